package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.PictureDifference;
import dev.twister.oracle.Pictures;
import dev.twister.oracle.RandomMeshes;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Scenes with meshes in lanes are those of the scalar kernel. */
class MeshesInLanesTest {
    private static final int SCENES = 40;
    private static final int ALWAYS_WALK = 0;
    private static final int NEVER_WALK = Integer.MAX_VALUE;

    static Stream<Object[]> widthsAndWays() {
        return Stream.of(128, 256, 512)
                .flatMap(bits -> Stream.of(ALWAYS_WALK, NEVER_WALK).map(crowd -> new Object[] {bits, crowd}));
    }

    @ParameterizedTest(name = "{0} bits, crowds from {1} on")
    @MethodSource("widthsAndWays")
    void randomMeshesAreTheKernels(int bits, int crowd) {
        assertSame(WidthLoader.openForCrowds(bits, 2, crowd), SCENES);
    }

    @ParameterizedTest(name = "{0} bits, crowds from {1} on")
    @MethodSource("widthsAndWays")
    void declinedMeshesAreTheKernels(int bits, int crowd) {
        assertSame(WidthLoader.openDeclining(bits, 2, crowd, body -> body % 2 == 1), SCENES / 4);
    }

    private static void assertSame(Engine opened, int scenes) {
        int pixels = 0;
        int differing = 0;
        try (Engine engine = opened) {
            for (int seed = 0; seed < scenes; seed++) {
                LitScene scene = RandomMeshes.scene(new Random(seed), 3);
                PictureDifference difference = difference(engine, scene.world().snapshot());
                pixels += difference.pixels();
                differing += difference.differing().length;
            }
        }
        assertThat(differing).isLessThanOrEqualTo(pixels / PictureDifference.PIXELS_AN_ODD_ONE);
    }

    @ParameterizedTest(name = "{1} shadow samples at {0} bits")
    @CsvSource({"128, 1", "256, 9", "512, 1", "512, 9", "512, 32"})
    void shippedMeshesAreTheKernels(int bits, int shadowSamples) {
        for (int crowd : new int[] {ALWAYS_WALK, NEVER_WALK}) {
            try (Engine engine = WidthLoader.openForCrowds(bits, 2, crowd)) {
                for (String name : List.of("knot", "gallery", "pour-on-mesh")) {
                    Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
                    SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
                    World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
                    world.setSettings(world.settings()
                            .withSize(151, 87)
                            .withShadows(shadowSamples)
                            .withBounces(3));
                    assertThat(difference(engine, world.snapshot())).as(name).matches(PictureDifference::isWithinBound);
                }
            }
        }
    }

    private static PictureDifference difference(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.height());
        engine.render(input, frame);
        return PictureDifference.between(frame.argb(), Pictures.argb(JvmEngines.SEQUENTIAL, input));
    }
}
