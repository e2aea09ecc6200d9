package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import dev.twister.SceneBuilder;
import dev.twister.image.Frame;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.Pictures;
import dev.twister.oracle.ShippedScenes;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Albedo and normal of the first surface behind mirrors and clear glass. */
class GuidesTest {
    private static final int SIDE = 33;
    private static final int MIDDLE = 3 * (SIDE * (SIDE / 2) + SIDE / 2);
    private static final Offset<Float> CLOSE = offset(1e-3f);
    private static final Rgb GROUND = new Rgb(0.2, 0.4, 0.6);
    private static final Material MATTE = Material.DEFAULT.withReflectivity(0).withColor(new Rgb(0.7, 0.3, 0.1));

    @ParameterizedTest
    @CsvSource({"cornell,PATH", "glass,PATH", "glass,WHITTED", "metals,WHITTED", "lamps,WHITTED"})
    void thePictureKeepsItsBits(String scene, Integrator integrator) {
        FrameInput input = shipped(scene, integrator);

        assertThat(Pictures.linear(JvmEngines.PARALLEL, input.withGuides()).radiance())
                .isEqualTo(Pictures.linear(JvmEngines.PARALLEL, input).radiance());
    }

    @ParameterizedTest
    @CsvSource({"sequential,PATH", "vector,PATH", "sequential,WHITTED", "vector,WHITTED"})
    void areTheSameOnEveryEngine(String engine, Integrator integrator) {
        FrameInput input = shipped("glass", integrator).withGuides();

        assertThat(Pictures.linear(engine, input).layers())
                .isEqualTo(Pictures.linear(JvmEngines.PARALLEL, input).layers());
    }

    @ParameterizedTest
    @EnumSource(Integrator.class)
    void ofMatteSurfacesAreTheViews(Integrator integrator) {
        FrameInput input = ball(MATTE, integrator);
        Frame guided = Pictures.linear(JvmEngines.PARALLEL, input.withGuides());
        float[] albedo = Pictures.linear(JvmEngines.PARALLEL, input.showing(StageOrView.ALBEDO))
                .radiance();
        float[] normal = Pictures.linear(JvmEngines.PARALLEL, input.showing(StageOrView.NORMAL))
                .radiance();

        for (int i = 0; i < 3; i++) {
            assertThat(guided.layers()[MIDDLE + i]).isCloseTo(albedo[MIDDLE + i], CLOSE);
            assertThat(guided.layers()[guided.firstOf(1) + MIDDLE + i]).isCloseTo(2 * normal[MIDDLE + i] - 1, CLOSE);
        }
    }

    /** The camera looks down on the ball, which reflects the sky. */
    @ParameterizedTest
    @EnumSource(Integrator.class)
    void followMirrors(Integrator integrator) {
        Frame guided = Pictures.linear(
                JvmEngines.PARALLEL,
                ball(Material.DEFAULT.withReflectivity(128), integrator).withGuides());

        assertThat(guided.layers()[MIDDLE]).isCloseTo(0.5f, CLOSE);
        assertThat(guided.layers()[MIDDLE + 2]).isCloseTo(1f, CLOSE);
        assertThat(guided.layers()[guided.firstOf(1) + MIDDLE + 1]).isZero();
    }

    @ParameterizedTest
    @EnumSource(Integrator.class)
    void followClearGlass(Integrator integrator) {
        Material glass = Material.DEFAULT
                .withReflectivity(0)
                .withColor(new Rgb(1, 1, 1))
                .withTransmission(1)
                .withIor(1);
        Frame guided =
                Pictures.linear(JvmEngines.PARALLEL, ball(glass, integrator).withGuides());

        assertThat(guided.layers()[MIDDLE]).isCloseTo((float) GROUND.red(), CLOSE);
        assertThat(guided.layers()[MIDDLE + 2]).isCloseTo((float) GROUND.blue(), CLOSE);
        assertThat(guided.layers()[guided.firstOf(1) + MIDDLE + 1]).isCloseTo(1f, CLOSE);
    }

    @ParameterizedTest
    @EnumSource(Integrator.class)
    void stopAtRoughMirrors(Integrator integrator) {
        Material rough =
                Material.DEFAULT.withReflectivity(128).withRoughness(0.3).withColor(new Rgb(0.1, 0.9, 0.1));
        Frame guided =
                Pictures.linear(JvmEngines.PARALLEL, ball(rough, integrator).withGuides());

        assertThat(guided.layers()[MIDDLE + 1]).isCloseTo(0.9f, CLOSE);
    }

    @Test
    void tilesHaveTheBitsOfTheWhole() {
        FrameInput input = ball(MATTE, Integrator.PATH).withGuides();
        Frame whole = Pictures.linear(JvmEngines.PARALLEL, input);
        Frame band = Pictures.linear(JvmEngines.PARALLEL, input.band(16, 5));

        assertThat(whole.rows(16, 5).layers()).isEqualTo(band.layers());
        Frame put = Frame.ofRadiance(SIDE, SIDE, 2);
        put.put(band, 16);
        assertThat(put.rows(16, 5).layers()).isEqualTo(band.layers());
    }

    private static FrameInput ball(Material material, Integrator integrator) {
        return new SceneBuilder()
                .camera(Camera.of(new Vector3(0, 3, -4), 0, 30, 40))
                .ground(Ground.of(100, -1, GROUND, GROUND, 0))
                .sphere(Sphere.of(new Vector3(0, 0.69, 0), 1, material))
                .sky(new Rgb(0.5, 0.7, 3))
                .rendering(Rendering.DEFAULT
                        .withSize(SIDE, SIDE)
                        .withBounces(4)
                        .withIntegrator(integrator)
                        .withSamplesPerPixel(2))
                .world()
                .snapshot();
    }

    private static FrameInput shipped(String name, Integrator integrator) {
        LitScene small = ShippedScenes.small(name);
        World world = small.world();
        world.setSettings(small.scene()
                .rendering()
                .withSize(48, 27)
                .withIntegrator(integrator)
                .withShadowSamples(4)
                .withSamplesPerPixel(2));
        return world.snapshot();
    }
}
