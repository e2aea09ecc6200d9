package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.oracle.Pictures;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Stages and views on the JVM engines, in bands and with several samples, and counts known in closed form. */
class ViewsTest {
    private static final double MATTE = 0;
    private static final Skybox SKY = new Skybox(1, 1, new float[] {0.25f, 0.5f, 0.75f});
    private static final Camera AHEAD = Camera.of(new Vector3(0.5, 5, -5), 0, 0, 60);
    private static final Camera DOWN = Camera.of(new Vector3(0.5, 5, 0.5), 0, 90, 60);
    private static final int SHADOW_SAMPLES = 7;

    @ParameterizedTest
    @EnumSource(StageOrView.class)
    void enginesShowTheSame(StageOrView picture) {
        FrameInput input = crowd(2).showing(picture);
        float[] expected = Pictures.radiance(JvmEngines.SEQUENTIAL, input);

        assertThat(Pictures.radiance(JvmEngines.PARALLEL, input)).isEqualTo(expected);
        float[] lanes = Pictures.radiance("vector", input);
        long odd = IntStream.range(0, lanes.length)
                .filter(i -> Math.abs(lanes[i] - expected[i]) > Math.max(1, Math.abs(expected[i])) / 255)
                .count();
        assertThat(odd).isLessThanOrEqualTo(3);
    }

    @ParameterizedTest
    @EnumSource(StageOrView.class)
    void bandsComeToTheWhole(StageOrView picture) {
        FrameInput input = crowd(1).showing(picture);
        float[] whole = Pictures.radiance(JvmEngines.SEQUENTIAL, input);

        for (int first : new int[] {0, 11, 22}) {
            assertThat(Pictures.radiance(JvmEngines.SEQUENTIAL, input.band(first, 11)))
                    .isEqualTo(Arrays.copyOfRange(whole, 3 * 64 * first, 3 * 64 * (first + 11)));
        }
    }

    @ParameterizedTest
    @EnumSource(StageOrView.class)
    void pixelIsTheMeanOfItsSamples(StageOrView picture) {
        FrameInput input = crowd(3).showing(picture);
        float[] mean = Pictures.radiance(JvmEngines.SEQUENTIAL, input);
        float[][] samples = new float[3][];
        Arrays.setAll(samples, sample -> Pictures.radiance(JvmEngines.SEQUENTIAL, input.withSamples(sample, 1)));

        for (int i = 0; i < mean.length; i++) {
            float sum = samples[0][i] + samples[1][i] + samples[2][i];
            assertThat(mean[i]).isCloseTo(sum / 3, within(1e-5f * Math.max(1, Math.abs(sum))));
        }
    }

    @ParameterizedTest
    @CsvSource({
        "ALBEDO, 0",
        "NORMAL, 0",
        "DEPTH, 0",
        "BODY, -1",
        "SHADOW, 1",
        "BOUNCES, 0",
        "COLORS, 0.25",
        "HIGHLIGHTS, 0.25"
    })
    void nothingHasItsOwnNumber(StageOrView picture, double red) {
        assertThat(red(AHEAD, 3, MATTE, picture)).isEqualTo(red);
    }

    @ParameterizedTest
    @CsvSource({"ALBEDO, 0.9", "NORMAL, 0.5", "DEPTH, 4.5", "BODY, 0", "SHADOW, 1", "BOUNCES, 0", "DIFFUSE, 0.9"})
    void lightHasItsOwnNumber(StageOrView picture, double red) {
        Camera below = Camera.of(new Vector3(0, 5, 0), 0, -90, 60);
        assertThat(red(below, 3, MATTE, picture)).isCloseTo(red, within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 5})
    void rayIntoTheSkyIsTestedAgainstEachBody(int spheres) {
        assertThat(red(AHEAD, 3, MATTE, StageOrView.TESTS, beside(spheres))).isEqualTo(2 + spheres);
    }

    /** Each sphere adds one shadow test, as none comes near the light's disc. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 5})
    void litGroundLooksAtEachSphereOnce(int spheres) {
        assertThat(red(DOWN, 0, MATTE, StageOrView.TESTS, beside(spheres))).isEqualTo(2 + 2 * spheres);
    }

    /** A small sphere high above covers part of the disc, so each shadow ray is tested against it. */
    @Test
    void penumbraTestsEachShadowRay() {
        assertThat(red(DOWN, 0, MATTE, StageOrView.TESTS, sphere(0.25, 8, 0.25, 0.1, MATTE)))
                .isEqualTo(2 + 2 + SHADOW_SAMPLES);
    }

    @Test
    void mirrorsTestMoreThanOneRay() {
        assertThat(red(DOWN, 1, 128, StageOrView.TESTS)).isEqualTo(2 + 1);
        assertThat(red(DOWN, 1, 128, StageOrView.BOUNCES)).isEqualTo(1);
        assertThat(red(DOWN, 0, 128, StageOrView.BOUNCES)).isZero();
    }

    /**
     * At normal incidence a glass ball splits the ray in two; the inner ray splits again at each bounce, and the outer
     * ones leave the scene.
     */
    @ParameterizedTest
    @CsvSource({"0, 0", "1, 2", "2, 4"})
    void glassFollowsBothRays(int bounces, int followed) {
        Sphere ball = sphere(0.5, 5, 0, 1, MATTE);
        Sphere glass = ball.withMaterial(ball.material().withTransmission(1).withColor(new Rgb(1, 1, 1)));
        assertThat(red(AHEAD, bounces, MATTE, StageOrView.BOUNCES, glass)).isEqualTo(followed);
    }

    /** The ball's upper side is closer to the light, and a body does not shade itself. */
    @Test
    void shadowIsFoundWhereItChangesNothing() {
        Sphere ball = sphere(0.5, 5, 0, 1, MATTE);
        Sphere blocker = sphere(0.35, 7.5, -0.5, 1, MATTE);
        assertThat(red(AHEAD, 0, MATTE, StageOrView.SHADOW, ball)).isEqualTo(1);
        assertThat(red(AHEAD.withPosition(new Vector3(0.5, 4.6, -5)), 0, MATTE, StageOrView.SHADOW, ball, blocker))
                .isLessThan(1);
    }

    private static double red(
            Camera camera, int bounces, double groundReflectivity, StageOrView picture, Sphere... spheres) {
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(camera)
                .withLights(Lights.of(Light.of(new Vector3(0, 10, 0), 0.5, new Rgb(0.9, 1, 1))))
                .withGround(Ground.of(20, 0, new Rgb(0.8, 0.8, 0.8), new Rgb(0.3, 0.3, 0.3), groundReflectivity))
                .withSpheres(List.of(spheres))
                .withShading(new Shading(0.1))
                .withRendering(
                        Rendering.DEFAULT.withSize(1, 1).withBounces(bounces).withShadowSamples(SHADOW_SAMPLES));
        return Pictures.radiance(
                JvmEngines.SEQUENTIAL, World.of(scene, SKY).snapshot().showing(picture))[0];
    }

    /** Spheres far to the side, outside the view. */
    private static Sphere[] beside(int spheres) {
        Sphere[] beside = new Sphere[spheres];
        Arrays.setAll(beside, i -> sphere(-9, 1, 3 * i, 1, MATTE));
        return beside;
    }

    private static Sphere sphere(double x, double y, double z, double radius, double reflectivity) {
        return Sphere.of(new Vector3(x, y, z), radius, new Rgb(0.5, 0.5, 0.5), reflectivity);
    }

    private static FrameInput crowd(int samples) {
        Scene scene = SceneReader.read(Path.of("scenes/spheres-100.json"));
        return World.of(
                        scene.withRendering(scene.rendering()
                                .withSize(64, 33)
                                .withShadowSamples(5)
                                .withBounces(2)
                                .withSamplesPerPixel(samples)),
                        SkyboxReader.read(scene.sky().file()))
                .snapshot();
    }
}
