package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.WindowScenes;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import dev.twister.image.Frame;
import dev.twister.oracle.Crowds;
import dev.twister.scene.Camera;
import dev.twister.scene.Integrator;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class PreviewTest {
    private static final EngineChoice ENGINE = new EngineChoice(1, JvmEngines.parallel());

    @Test
    void aSlowPictureIsPrecededByOneAsSmallAsItTakes() {
        assertThat(Preview.divisor(0, false)).isEqualTo(1);
        assertThat(Preview.divisor(TimeUnit.MILLISECONDS.toNanos(150), false)).isEqualTo(1);
        assertThat(Preview.divisor(TimeUnit.MILLISECONDS.toNanos(200), false)).isEqualTo(2);
        assertThat(Preview.divisor(TimeUnit.MILLISECONDS.toNanos(900), false)).isEqualTo(4);
        assertThat(Preview.divisor(TimeUnit.MINUTES.toNanos(1), false)).isEqualTo(8);
        assertThat(Preview.divisor(TimeUnit.MINUTES.toNanos(1), true)).isEqualTo(16);
    }

    @Test
    void withoutItsNoiseItIsNearerToManySamples() {
        World world = tracedCrowd();
        FrameInput input = world.snapshot();
        try (Engine engine = JvmEngines.parallel().opener().get()) {
            Frame wanted = Frame.ofPixels(48, 32);
            engine.render(input.withSamples(0, 256), wanted);
            Frame noisy = Frame.ofPixels(48, 32);
            Preview.gathering(input, false, false, Optional.empty(), () -> 0).draw(engine, noisy);
            Frame clean = Frame.ofPixels(48, 32);
            Preview preview = Preview.gathering(input, false, true, Optional.empty(), () -> 0);
            preview.draw(engine, clean);

            assertThat(error(clean, wanted)).isLessThan(0.75 * error(noisy, wanted));
            preview.draw(engine, clean);
            preview.draw(engine, clean);
            assertThat(preview.samples()).isEqualTo(4);
            assertThat(error(clean, wanted)).isLessThan(0.5 * error(noisy, wanted));
        }
    }

    @Test
    void aMovedCameraUsesTheSamplesOfBefore() {
        World world = tracedCrowd();
        try (Engine engine = JvmEngines.parallel().opener().get()) {
            Frame frame = Frame.ofPixels(48, 32);
            Preview before = Preview.gathering(world.snapshot(), false, true, Optional.empty(), () -> 0);
            before.draw(engine, frame);
            before.draw(engine, frame);
            world.setCamera(world.camera().withYawDegrees(world.camera().yawDegrees() + 1));
            FrameInput input = world.snapshot();
            Frame wanted = Frame.ofPixels(48, 32);
            engine.render(input.withSamples(0, 256), wanted);
            Frame alone = Frame.ofPixels(48, 32);
            Preview.gathering(input, false, true, Optional.empty(), () -> 0).draw(engine, alone);
            Preview.gathering(input, false, true, before.history(), () -> 0).draw(engine, frame);

            assertThat(before.history().orElseThrow().nextSample()).isEqualTo(2);
            assertThat(error(frame, wanted)).isLessThan(error(alone, wanted));
        }
    }

    @Test
    void onlyTheCameraMayHaveMoved() {
        Scene scene = WindowScenes.tiny();
        Camera camera = scene.camera();
        DrawingRequest request = request(scene);

        assertThat(request(scene.withCamera(camera.withYawDegrees(camera.yawDegrees() + 1)))
                        .looksFromElsewhereThan(request))
                .isTrue();
        assertThat(request(scene.withCamera(camera.withAperture(0.5))).looksFromElsewhereThan(request))
                .isFalse();
        assertThat(request(scene.withSpheres(List.of())).looksFromElsewhereThan(request))
                .isFalse();
        assertThat(request.looksFromElsewhereThan(request)).isFalse();
    }

    private static World tracedCrowd() {
        World world = Crowds.world(60, 48, 32);
        world.setSettings(world.settings()
                .withIntegrator(Integrator.PATH)
                .withSize(48, 32)
                .withSamplesPerPixel(1));
        return world;
    }

    private static DrawingRequest request(Scene scene) {
        return new DrawingRequest(1, scene, 48, 32, ENGINE, 1);
    }

    private static double error(Frame frame, Frame wanted) {
        double sum = 0;
        for (int i = 0; i < frame.argb().length; i++) {
            int difference = (frame.argb()[i] >> 8 & 0xFF) - (wanted.argb()[i] >> 8 & 0xFF);
            sum += difference * difference;
        }
        return sum;
    }
}
