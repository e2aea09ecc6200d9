package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.JvmEngines;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What suns and spots light, by formula. */
class SunsAndSpotsTest {
    private static final int SIDE = 8;
    private static final Rgb WHITE = new Rgb(1, 1, 1);
    private static final Skybox NIGHT = new Skybox(1, 1, new float[3]);

    /** A white floor has the radiance {@code color * strength * cos}, however large the disc is. */
    @ParameterizedTest
    @CsvSource({"0, 0", "0, 60", "0.53, 30", "20, 0", "20, 70"})
    void floorsHaveTheSunsRadianceTimesTheCosine(double angularDiameter, double fromZenith) {
        Light sun = Light.sun(slanted(fromZenith), angularDiameter)
                .withColor(new Rgb(1, 0.5, 0.25))
                .withStrength(3.0);
        double expected = 3 * Math.cos(Math.toRadians(fromZenith));

        double[] means = means(floor(Integrator.PATH, List.of(sun)), 64);

        assertThat(means[0]).isCloseTo(expected, within(0.003 * expected));
        assertThat(means[1]).isCloseTo(expected / 2, within(0.003 * expected / 2));
        assertThat(means[2]).isCloseTo(expected / 4, within(0.003 * expected / 4));
    }

    /** Without path tracing it is the same but for the strength. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 60})
    void floorsOfWhittedHaveTheShareTimesTheCosine(double fromZenith) {
        Light sun = Light.sun(slanted(fromZenith), 1).withShare(0.75);

        double[] means = means(floor(Integrator.WHITTED, List.of(sun)), 1);

        assertThat(means[0]).isCloseTo(0.75 * Math.cos(Math.toRadians(fromZenith)), within(1e-6));
    }

    /** Several suns add up, beside a lamp, whichever comes first. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void sunsAddUp(boolean lampFirst) {
        Light lamp = Light.of(new Vector3(-6, 8, 0), 0.01, WHITE).withStrength(62.5);
        List<Light> suns = List.of(Light.sun(slanted(0), 0), Light.sun(slanted(60), 5));
        Lights lights = lampFirst ? Lights.of(lamp).with(suns) : new Lights(suns).with(List.of(lamp));

        double[] means = means(floor(Integrator.PATH, lights.list()), 1024);

        assertThat(means[0]).isCloseTo(1 + 0.5 + 0.5, within(0.003 * 2));
    }

    /** A spot's light over the squared distance falls off by the angle with its axis as glTF has it. */
    @ParameterizedTest
    @CsvSource({
        "60, 0.5, 0",
        "60, 0.5, 10",
        "60, 0.5, 20",
        "60, 0.5, 25",
        "60, 0.5, 31",
        "60, 0, 29",
        "180, 1, 45",
        "20, 0.2, 9"
    })
    void spotsFallOffAsInGltf(double coneAngle, double coneBlend, double degrees) {
        Light spot = Light.spot(new Vector3(0, 10, 0), 0.01, slanted(degrees), coneAngle);
        Light light = spot.withShape(spot.shape().withConeBlend(coneBlend)).withStrength(300.0);
        double outer = Math.cos(Math.toRadians(coneAngle / 2));
        double inner = Math.cos(Math.toRadians(coneAngle / 2 * (1 - coneBlend)));
        double cosine = Math.cos(Math.toRadians(degrees));
        double expected = Math.pow(Math.clamp((cosine - outer) / Math.max(0.001, inner - outer), 0, 1), 2);

        double[] traced = means(floor(Integrator.PATH, List.of(light)), 16);
        double[] shaded = means(floor(Integrator.WHITTED, List.of(light)), 1);

        assertThat(traced[0]).isCloseTo(3 * expected, within(0.003 * 3 * expected));
        assertThat(shaded[0]).isCloseTo(expected, within(0.003 * expected));
    }

    private static Vector3 slanted(double degreesFromZenith) {
        double angle = Math.toRadians(degreesFromZenith);
        return new Vector3(7 * Math.sin(angle), -7 * Math.cos(angle), 0);
    }

    /** A white floor at night, of which the camera sees a small part about the origin. */
    private static LitScene floor(Integrator integrator, List<Light> lights) {
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 5, -0.5), 0, 84.29, 0.1))
                .withGround(Ground.of(50, 0, WHITE, WHITE, 0))
                .withLights(new Lights(lights))
                .withShading(new Shading(0))
                .withRendering(Rendering.DEFAULT
                        .withSize(SIDE, SIDE)
                        .withIntegrator(integrator)
                        .withClamp(0));
        return new LitScene(scene, NIGHT);
    }

    private static double[] means(LitScene lit, int samples) {
        float[] radiance =
                Pictures.radiance(JvmEngines.SEQUENTIAL, lit.world().snapshot().withSamples(0, samples));
        double[] means = new double[3];
        for (int i = 0; i < radiance.length; i++) {
            means[i % 3] += radiance[i] / (SIDE * SIDE);
        }
        return means;
    }
}
