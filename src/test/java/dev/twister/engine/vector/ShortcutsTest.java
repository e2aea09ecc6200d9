package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.vector.frame.Shortcut;
import dev.twister.engine.vector.frame.Shortcuts;
import dev.twister.image.Frame;
import dev.twister.oracle.PictureDifference;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Pictures without one of the shortcuts, or without any, equal {@code sequential}'s. */
final class ShortcutsTest {
    private static final int CROWD = 100;
    private static final List<FrameInput> INPUTS = List.of(
            shipped("benchmark"),
            shipped("mirrors"),
            SampleWorld.crowd(CROWD + 50, 160, 90).snapshot());

    @ParameterizedTest
    @EnumSource
    void aShortcutLeavesThePictureAsItIs(Shortcut shortcut) {
        assertSame(Shortcuts.without(shortcut));
    }

    @Test
    void noneAtAllDoesSoToo() {
        assertSame(Shortcuts.none());
    }

    private static void assertSame(Shortcuts shortcuts) {
        try (Engine vector = VectorEngines.open(2, CROWD, shortcuts);
                Engine sequential = Engines.open("sequential")) {
            for (FrameInput input : INPUTS) {
                assertThat(PictureDifference.between(pixels(vector, input), pixels(sequential, input))
                                .isWithinBound())
                        .isTrue();
            }
        }
    }

    private static int[] pixels(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        engine.render(input, frame);
        return frame.argb();
    }

    private static FrameInput shipped(String name) {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        World world = World.of(scene, SkyboxReader.read(scene.sky().file()));
        world.setSettings(world.settings().withSize(320, 180).withShadowSamples(64));
        return world.snapshot();
    }
}
