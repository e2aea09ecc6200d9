package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.scene.Camera;
import dev.twister.scene.RenderSettings;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the engine keeps between frames, and sizes that no work group divides. */
class TornadoEngineTest {
    private final World world = SceneSamples.world(3, 6);

    private FrameInput input(int width, int height) {
        world.setSettings(RenderSettings.DEFAULT.withSize(width, height).withShadows(16));
        return world.snapshot();
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "17, 3", "3, 17", "1, 64", "101, 57", "257, 13"})
    void oddSizesAreDrawnWhole(int width, int height) {
        try (Engine engine = Devices.openFirst()) {
            Pictures.requireSequentials(engine, input(width, height));
        }
    }

    @Test
    void linearFramesHoldTheRadiance() {
        try (Engine engine = Devices.openFirst()) {
            Pictures.requireSequentialsRadiance(engine, input(31, 19));
        }
    }

    @Test
    void bandsAreDrawnWithoutCompilingAgain() {
        try (TornadoEngine engine = Devices.openFirst()) {
            FrameInput whole = input(40, 30);
            Pictures.requireSequentials(engine, whole.band(0, 10));
            DevicePlan plan = engine.plan().orElseThrow();
            Pictures.requireSequentials(engine, whole.band(10, 10));
            Pictures.requireSequentials(engine, whole.band(20, 10));
            assertThat(engine.plan()).containsSame(plan);
        }
    }

    @Test
    void whatChangesFromFrameToFrameNeedsNoCompilation() {
        try (TornadoEngine engine = Devices.openFirst()) {
            Pictures.requireSequentials(engine, input(40, 30));
            DevicePlan plan = engine.plan().orElseThrow();
            world.setCamera(new Camera(new Vector3(2, 1, -14), 10, 5, 70));
            Pictures.requireSequentials(engine, world.snapshot());
            RenderSettings settings = world.settings();
            world.setSettings(settings.withShadows(RenderSettings.MAX_SHADOW_SAMPLES));
            Pictures.requireSequentials(engine, world.snapshot());
            world.setSettings(settings.withBounces(RenderSettings.MAX_BOUNCES));
            Pictures.requireSequentials(engine, world.snapshot());
            world.setSettings(settings.withSamplesPerPixel(RenderSettings.MAX_SAMPLES_PER_PIXEL)
                    .withShadows(1));
            Pictures.requireSequentials(engine, world.snapshot());
            world.setSettings(settings.withTone(1.5, ToneMap.REINHARD, true));
            Pictures.requireSequentials(engine, world.snapshot());
            assertThat(engine.plan()).containsSame(plan);
        }
    }

    @Test
    void anotherSizeOrOtherBodiesAreCompiledAnew() {
        try (TornadoEngine engine = Devices.openFirst()) {
            Pictures.requireSequentials(engine, input(40, 30));
            DevicePlan plan = engine.plan().orElseThrow();
            Pictures.requireSequentials(engine, input(30, 40));
            DevicePlan turned = engine.plan().orElseThrow();
            assertThat(turned).isNotSameAs(plan);
            // Another world of as many bodies has other arrays, its skybox among them.
            World other = SceneSamples.world(4, 6);
            other.setSettings(world.settings());
            Pictures.requireSequentials(engine, other.snapshot());
            assertThat(engine.plan().orElseThrow()).isNotSameAs(turned);
        }
    }

    @Test
    void enginesOnOneDeviceDoNotDisturbEachOther() {
        FrameInput small = input(20, 10);
        FrameInput large = input(33, 21);
        try (Engine another = Devices.openFirst()) {
            try (Engine one = Devices.openFirst()) {
                Pictures.requireSequentials(one, small);
                Pictures.requireSequentials(another, large);
                Pictures.requireSequentials(one, small);
            }
            Pictures.requireSequentials(another, large);
        }
    }

    @Test
    void onlyWhatChangesIsCopiedAfterTheFirstFrame() {
        try (TornadoEngine engine = Devices.openFirst()) {
            FrameInput input = input(64, 36);
            Frame frame = Frame.ofPixels(64, 36);
            engine.render(input, frame);
            engine.render(input, frame);
            DevicePlan.Copied copied = engine.plan().orElseThrow().lastCopied();
            long sampleTables = 4L * 2 * (RenderSettings.MAX_SHADOW_SAMPLES + RenderSettings.MAX_SAMPLES_PER_PIXEL);
            // Beyond the arrays' content TornadoVM copies a header each and its own tables.
            assertThat(copied.bytesIn()).isBetween(1L, sampleTables + 4096);
            assertThat(copied.bytesOut()).isBetween(4L * 64 * 36, 4L * 64 * 36 + 256);
            assertThat(frame.times().kernelNanos()).isPositive();
        }
    }

    @Test
    void closingGivesTheDevicesMemoryBack() {
        FrameInput input = input(16, 9);
        long firstHeld = -1;
        for (int round = 0; round < 20; round++) {
            DevicePlan plan;
            try (TornadoEngine engine = Devices.openFirst()) {
                engine.render(input, Frame.ofPixels(16, 9));
                plan = engine.plan().orElseThrow();
                firstHeld = firstHeld < 0 ? plan.deviceBytes() : firstHeld;
                assertThat(plan.deviceBytes())
                        .as("bytes held on the device in round %d", round)
                        .isEqualTo(firstHeld);
            }
            assertThat(plan.deviceBytes()).as("bytes left on the device").isZero();
            plan.close();
        }
    }
}
