package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.JvmEngines;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Emission;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Furnace tests: under uniform light, a lossless body is invisible, and a body with the index of air is always
 * invisible.
 */
class FurnaceTest {
    private static final Rgb BLACK = new Rgb(0, 0, 0);
    private static final Rgb WHITE = new Rgb(1, 1, 1);
    private static final Skybox WHITE_SKY = new Skybox(1, 1, new float[] {1, 1, 1});
    private static final Material GLASS = Material.DEFAULT.withTransmission(1);

    /**
     * Branches below 1/1024 end, which loses a little energy. Nested bodies, whose rays split repeatedly, lose more
     * than this.
     */
    @ParameterizedTest
    @CsvSource({"1.5, 1", "1.5, 4", "1.5, 8", "1.5, 64", "1, 8", "1.1, 8", "2.42, 8", "4, 8", "4, 64"})
    void whiteGlassStaysWhite(double ior, int bounces) {
        for (float channel : furnace(GLASS.withIor(ior), bounces)) {
            assertThat(channel).isCloseTo(1f, within(0.01f));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.5, 0.9})
    void whiteGlassThatPassesAPartStaysWhite(double transmission) {
        for (float channel : furnace(GLASS.withTransmission(transmission).withReflectivity(40), 8)) {
            assertThat(channel).isCloseTo(1f, within(0.01f));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 8, 64})
    void smoothMirrorIsExactlyWhite(int bounces) {
        for (float channel : furnace(Material.DEFAULT.withReflectivity(128), bounces)) {
            assertThat(channel).isEqualTo(1f);
        }
    }

    @Test
    void glassOfIndexOneIsInvisible() {
        Random random = new Random(20261125);
        for (int i = 0; i < 20; i++) {
            LitScene lit = RandomScenes.scene(random, 2 + random.nextInt(3));
            Scene scene = lit.scene();
            Rendering settings = scene.rendering().withBounces(32);
            Material invisible = GLASS.withIor(1);
            List<Sphere> spheres =
                    new ArrayList<>(scene.spheres().stream().limit(8).toList());
            Scene without = scene.withRendering(settings).withSpheres(List.copyOf(spheres));
            spheres.add(Sphere.of(new Vector3(0, 1, 0), 3, invisible));
            spheres.add(Sphere.of(new Vector3(0.5, 1.5, 0), 1, invisible));
            spheres.add(Sphere.of(new Vector3(-2, 3, 2), 2, invisible));
            Scene with = without.withSpheres(spheres).withGround(scene.ground());
            PictureDifference difference = PictureDifference.between(
                    Pictures.argb(JvmEngines.SEQUENTIAL, with, lit.sky()),
                    Pictures.argb(JvmEngines.SEQUENTIAL, without, lit.sky()));
            assertThat(difference).matches(PictureDifference::isWithinBound, "is within the design's bound");
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 1})
    void specularIsAFactorOfWhatADielectricReflects(double specular) {
        Material black = Material.DEFAULT.withColor(BLACK).withRoughness(0.4);
        float[] all = traced(black);
        float[] reflected = traced(black.withSpecular(specular));

        for (int i = 0; i < all.length; i++) {
            assertThat(reflected[i]).isCloseTo((float) specular * all[i], within(1e-5f));
        }
        assertThat(all[all.length / 2]).isBetween(0.01f, 0.2f);
    }

    @ParameterizedTest
    @CsvSource({"0, 0.4, 0", "0.5, 0.4, 0", "0, 0.3, 1", "0.5, 0, 1"})
    void whatSpecularDoesNotReflectGoesOn(double specular, double roughness, double transmission) {
        Material white = Material.DEFAULT
                .withRoughness(roughness)
                .withTransmission(transmission)
                .withSpecular(specular);

        assertThat(mean(traced(white))).isCloseTo(1, within(0.005));
    }

    @ParameterizedTest
    @CsvSource({"0, 0.1, 0", "0, 1, 0", "0.5, 0.5, 0", "1, 0.6, 0", "1, 1, 0", "0, 0.4, 1", "0, 0.3, 0.5"})
    void whatIsWhiteByFresnelStaysWhite(double metallic, double roughness, double transmission) {
        Material white =
                Material.DEFAULT.withMetallic(metallic).withRoughness(roughness).withTransmission(transmission);

        assertThat(mean(traced(white))).isCloseTo(1, within(0.005));
    }

    private static double mean(float[] radiance) {
        double sum = 0;
        for (float channel : radiance) {
            sum += channel;
        }
        return sum / radiance.length;
    }

    /** The rays from a lamp spread where they leave the glass around it, so that it appears larger and darker. */
    @Test
    void aLampInGlassLosesRadianceByTheSquareOfTheIndex() {
        Material lamp = Material.DEFAULT
                .withColor(BLACK)
                .withEmission(Emission.NONE.withColor(WHITE).withStrength(90));
        List<Sphere> ball =
                List.of(Sphere.of(new Vector3(0, 5, 0), 1, GLASS), Sphere.of(new Vector3(0, 5, 0), 0.5, lamp));

        float[] radiance = traced(ball, 2);

        // What passes of light along the normal.
        double passed = 0.96;
        assertThat(mean(radiance)).isCloseTo(90 * passed / (1.5 * 1.5) + 0.04, within(0.4));
    }

    /** Traces paths to spheres that fill the picture, under a white sky. */
    private static float[] traced(Material material) {
        return traced(List.of(Sphere.of(new Vector3(0, 5, 0), 1, material)), 10);
    }

    private static float[] traced(List<Sphere> spheres, double fieldOfView) {
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 5, -4), 0, 0, fieldOfView))
                .withLights(Lights.of(Light.of(new Vector3(0, 50, 0), 0.1, BLACK)))
                .withGround(Ground.of(1, -1e5, BLACK, BLACK, 0))
                .withSpheres(spheres)
                .withRendering(Rendering.DEFAULT
                        .withSize(12, 12)
                        .withSamplesPerPixel(256)
                        .withIntegrator(Integrator.PATH)
                        .withClamp(0)
                        .withBounces(64));
        return Pictures.radiance(JvmEngines.SEQUENTIAL, scene, WHITE_SKY);
    }

    /** Renders spheres of one material on white ground under a white sky, in linear radiance. */
    private static float[] furnace(Material material, int bounces) {
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 1.5, -4), 0, 5, 60))
                .withLights(Lights.of(Light.of(new Vector3(0, 50, 0), 0.1, BLACK)))
                .withGround(Ground.of(20, 0, WHITE, WHITE, 0))
                .withSpheres(List.of(
                        Sphere.of(new Vector3(0, 1, 0), 1, material),
                        Sphere.of(new Vector3(1.5, 0.5, 1), 0.5, material)))
                .withShading(new Shading(1))
                .withRendering(Rendering.DEFAULT.withSize(48, 36).withBounces(bounces));
        return Pictures.radiance(JvmEngines.SEQUENTIAL, scene, WHITE_SKY);
    }
}
