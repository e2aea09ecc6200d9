package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.kernel.Variant;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.world.FrameInput;
import java.util.List;
import java.util.Random;
import java.util.function.BiFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares random scenes with 2 to 5 lights with the oracle. */
class SeveralLightsTest {
    private static final int PIXELS_AN_EXCUSE = 5000;

    /** Triangles of a few pixels have many edges. */
    private static final int MESH_PIXELS_AN_EXCUSE = 2000;

    private final ShownWorld world = new ShownWorld();

    @Test
    void plainScenesAreTheOracles() {
        PixelJudge judge = new PixelJudge();
        for (int seed = 0; seed < 60; seed++) {
            Random random = new Random(seed);
            LitScene scene = RandomLights.added(RandomScenes.scene(random, random.nextInt(4)), random);
            judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, world.input(scene)), scene);
        }
        judge.requireExcusedAtMostOneIn(PIXELS_AN_EXCUSE);
    }

    @Test
    void materialsAreTheOracles() {
        PixelJudge judge = new PixelJudge();
        for (int seed = 0; seed < 40; seed++) {
            Random random = new Random(seed);
            LitScene scene = RandomLights.added(RandomMaterials.scene(random, random.nextInt(4)), random);
            judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, world.input(scene)), scene);
        }
        judge.requireExcusedAtMostOneIn(PIXELS_AN_EXCUSE);
    }

    @Test
    void meshesAreTheOracles() {
        PixelJudge judge = new PixelJudge();
        for (int seed = 0; seed < 15; seed++) {
            Random random = new Random(seed);
            LitScene scene = RandomLights.added(RandomMeshes.scene(random, random.nextInt(4)), random);
            judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, world.input(scene)), scene);
        }
        judge.requireExcusedAtMostOneIn(MESH_PIXELS_AN_EXCUSE);
    }

    @Test
    void sunsAreTheOracles() {
        requireOracles(RandomLights::ofSuns);
    }

    @Test
    void spotsAreTheOracles() {
        requireOracles(RandomLights::ofSpots);
    }

    private void requireOracles(BiFunction<LitScene, Random, LitScene> lights) {
        PixelJudge judge = new PixelJudge();
        for (int seed = 0; seed < 30; seed++) {
            Random random = new Random(seed);
            LitScene lit = seed % 3 == 0
                    ? RandomMeshes.scene(random, random.nextInt(4))
                    : RandomMaterials.scene(random, random.nextInt(4));
            LitScene scene = lights.apply(lit, random);
            judge.judge(Pictures.argb(JvmEngines.SEQUENTIAL, world.input(scene)), scene);
        }
        judge.requireExcusedAtMostOneIn(MESH_PIXELS_AN_EXCUSE);
    }

    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.PARALLEL, "vector"})
    void enginesAgreeOnSunsAndSpots(String engine) {
        for (int seed = 0; seed < 6; seed++) {
            Random random = new Random(seed);
            LitScene lit = RandomMaterials.scene(random, 3);
            LitScene scene = seed % 2 == 0 ? RandomLights.ofSuns(lit, random) : RandomLights.ofSpots(lit, random);
            FrameInput input = world.input(scene);
            assertThat(Pictures.argb(engine, input)).isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, input));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.PARALLEL, "vector"})
    void enginesAgreeBitForBit(String engine) {
        for (int seed = 0; seed < 12; seed++) {
            Random random = new Random(seed);
            LitScene lit = seed % 3 == 0 ? RandomMeshes.scene(random, 3) : RandomMaterials.scene(random, 3);
            LitScene scene = RandomLights.added(lit, random);
            FrameInput input = world.input(scene);
            assertThat(Pictures.argb(engine, input)).isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, input));
        }
    }

    /** The equations for several lights are the paper's if all but one are black. */
    @Test
    void lightsThatAddNothingChangeNothing() {
        for (int seed = 0; seed < 20; seed++) {
            LitScene lit = RandomMaterials.scene(new Random(seed), 3);
            Scene one = lit.scene();
            Light first = one.lights().first();
            Light none = first.withShare(0).withColor(new Rgb(0, 0, 0)).withPosition(new Vector3(3e5, 3e5, 3e5));
            Scene two = one.withLights(new Lights(List.of(first, none)));
            LitScene scene = new LitScene(two, lit.images(), lit.meshes());
            FrameInput input = world.input(scene);
            assertThat(input.variant(false) & Variant.LIGHTS).isNotZero();
            assertThat(Pictures.argb(JvmEngines.SEQUENTIAL, input))
                    .isEqualTo(Pictures.argb(JvmEngines.SEQUENTIAL, world.input(lit)));
        }
    }
}
