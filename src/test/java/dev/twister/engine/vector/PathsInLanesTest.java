package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.oracle.PictureDifference;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Traced paths whose hits lanes find are those of the scalar kernel. */
final class PathsInLanesTest {
    private static final int CROWD = 250;

    static Stream<Object[]> widthsAndScenes() {
        return WidthLoader.WIDTHS.stream()
                .flatMap(bits -> Stream.of("weekend", "lamps", "cornell").map(scene -> new Object[] {bits, scene}));
    }

    @ParameterizedTest(name = "{1} at {0} bits")
    @MethodSource("widthsAndScenes")
    void shippedScenesAreTheSame(int bits, String scene) {
        FrameInput input = shipped(scene);
        try (Engine vector = WidthLoader.openForCrowds(bits, 2, CROWD);
                Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
            assertThat(vector.declines(input)).isFalse();
            assertThat(PictureDifference.between(pixels(vector, input), pixels(sequential, input)))
                    .matches(PictureDifference::isWithinBound);
        }
    }

    private static FrameInput shipped(String name) {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
        world.setSettings(world.settings().withSize(71, 43).withSamplesPerPixel(3));
        return world.snapshot();
    }

    private static int[] pixels(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        engine.render(input, frame);
        return frame.argb();
    }
}
