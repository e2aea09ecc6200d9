package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Pictures with more samples per pixel approach the one of 1,024 at least as fast as random sampling would. */
class ConvergenceTest {
    private static final int[] SAMPLES = {4, 16, 64, 256};
    private static final int MOST_SAMPLES = 1024;
    private static final Skybox SKY = new Skybox(4, 2, new float[] {
        1, 0.2f, 0.1f, 0.1f, 1, 0.2f, 0.2f, 0.1f, 1, 2, 2, 2, 0.1f, 0.1f, 0, 0, 0.3f, 0, 0.5f, 0, 0, 0, 0, 0.2f
    });

    @Test
    void roughMirrorsConverge() {
        requireConvergence(scene(Material.DEFAULT.withReflectivity(128).withRoughness(0.5)));
    }

    @Test
    void roughGlassConverges() {
        requireConvergence(scene(Material.DEFAULT.withTransmission(1).withRoughness(0.4)));
    }

    @Test
    void whatIsOutOfFocusConverges() {
        Scene sharp = scene(Material.DEFAULT.withReflectivity(64));
        requireConvergence(sharp.withCamera(sharp.camera().withAperture(0.3).withFocusDistance(2)));
    }

    private static void requireConvergence(Scene scene) {
        float[] converged = radiance(scene, MOST_SAMPLES);
        double[] errors = Arrays.stream(SAMPLES)
                .mapToDouble(samples -> error(radiance(scene, samples), converged))
                .toArray();
        double first = errors[0];
        for (int i = 1; i < errors.length; i++) {
            assertThat(errors[i])
                    .as(
                            "root mean square errors %s of %s samples of a pixel against %d",
                            Arrays.toString(errors), Arrays.toString(SAMPLES), MOST_SAMPLES)
                    .isLessThanOrEqualTo(first / Math.sqrt((double) SAMPLES[i] / SAMPLES[0]));
        }
    }

    private static float[] radiance(Scene scene, int samples) {
        return Pictures.radiance(
                JvmEngines.PARALLEL, scene.withRendering(scene.rendering().withSamplesPerPixel(samples)), SKY);
    }

    private static double error(float[] actual, float[] expected) {
        double squares = 0;
        for (int i = 0; i < actual.length; i++) {
            squares += (actual[i] - expected[i]) * (actual[i] - expected[i]);
        }
        return Math.sqrt(squares / actual.length);
    }

    private static Scene scene(Material material) {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 1.5, -4), 0, 8, 50))
                .withLights(Lights.of(Light.of(new Vector3(3, 5, -3), 0.5, new Rgb(1, 1, 1))))
                .withGround(Ground.of(20, 0, new Rgb(0.8, 0.8, 0.8), new Rgb(0.3, 0.3, 0.3), 0))
                .withSpheres(List.of(
                        Sphere.of(new Vector3(-0.9, 1, 0), 1, material),
                        Sphere.of(new Vector3(1.1, 0.8, 0.5), 0.8, material)))
                .withRendering(
                        Rendering.DEFAULT.withSize(32, 24).withShadowSamples(1).withBounces(3));
    }
}
