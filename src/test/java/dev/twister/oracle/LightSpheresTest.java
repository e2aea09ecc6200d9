package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.scene.Camera;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Emission;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Lights are spheres: in path tracing they give the picture of spheres that emit, wherever they are kept. */
class LightSpheresTest {
    private static final Skybox BLACK = new Skybox(1, 1, new float[] {0, 0, 0});
    private static final Skybox GRAY = new Skybox(1, 1, new float[] {0.4f, 0.5f, 0.6f});

    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.SEQUENTIAL, "vector"})
    void lightsArePicturedAsSpheresThatEmit(String engine) {
        for (int count : new int[] {2, 17, 300}) {
            List<Light> lights = new ArrayList<>();
            List<Sphere> spheres = new ArrayList<>();
            Random random = new Random(count);
            for (int i = 0; i < count; i++) {
                Vector3 place = new Vector3(
                        6 * random.nextDouble() - 3, 0.5 + random.nextDouble(), 6 * random.nextDouble() - 3);
                lights.add(Light.of(place, 0.125, new Rgb(1, 1, 0.5)).withStrength(0.125));
                Emission emission = new Emission(new Rgb(8, 8, 4), 1, true, LightGroup.NONE);
                spheres.add(Sphere.of(
                        place,
                        0.125,
                        Material.DEFAULT.withColor(new Rgb(0, 0, 0)).withEmission(emission)));
            }
            Light none = Light.DEFAULT.withStrength(0);
            float[] ofSpheres =
                    Pictures.radiance(engine, traced(Lights.of(none)).withSpheres(spheres), BLACK);
            float[] ofLights = Pictures.radiance(engine, traced(new Lights(lights)), BLACK);
            assertThat(ofLights).contains(8f);
            assertThat(ofLights).as("%d lights", count).isEqualTo(ofSpheres);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.SEQUENTIAL, "vector"})
    void aLightWithoutStrengthIsNotDrawn(String engine) {
        Light inView = Light.DEFAULT.withRadius(1).withPosition(new Vector3(0, 1, 0));
        Light behind = inView.withPosition(new Vector3(0, 1, 2)).withStrength(0);
        Scene hidden =
                traced(Lights.of(inView.withPosition(new Vector3(0, 1, -90)).withStrength(0)));
        Scene dark = traced(new Lights(List.of(inView.withStrength(0), behind, behind)));
        assertThat(Pictures.radiance(engine, dark, GRAY)).isEqualTo(Pictures.radiance(engine, hidden, GRAY));
        Scene whitted = dark.withRendering(dark.rendering().withIntegrator(Integrator.WHITTED));
        assertThat(Pictures.radiance(engine, whitted, GRAY)).contains(1f);
    }

    /** A spot between the camera and the sky that shines away from the camera, or to its side; and one in its cone. */
    @ParameterizedTest
    @CsvSource({"sequential, path", "vector, path", "sequential, whitted", "vector, whitted"})
    void aSpotIsSeenInItsConeAlone(String engine, String integrator) {
        Light none = Light.DEFAULT.withPosition(new Vector3(0, 1, -90));
        Integrator by = Integrator.valueOf(integrator.toUpperCase(Locale.ROOT));
        Light away = Light.spot(new Vector3(0, 1, 0), 1, new Vector3(0, 0, 1), 120);
        Light aside = away.withShape(away.shape().withDirection(new Vector3(1, 0, 0)));
        Light towards = away.withShape(away.shape().withDirection(new Vector3(0, 0, -1)));
        float[] sky = Pictures.radiance(JvmEngines.SEQUENTIAL, high(Lights.of(none), by), GRAY);

        assertThat(Pictures.radiance(engine, high(new Lights(List.of(away, none, aside)), by), GRAY))
                .isEqualTo(sky);
        assertThat(Pictures.radiance(engine, high(new Lights(List.of(none, away, aside)), by), GRAY))
                .isEqualTo(sky);
        assertThat(Pictures.radiance(engine, high(new Lights(List.of(none, towards)), by), GRAY))
                .isNotEqualTo(sky);
    }

    /** Above a ground that nobody sees. */
    private static Scene high(Lights lights, Integrator integrator) {
        Scene scene = traced(lights);
        return scene.withGround(scene.ground().withHeight(-900))
                .withRendering(scene.rendering().withIntegrator(integrator));
    }

    private static Scene traced(Lights lights) {
        Scene scene = Scene.under(Path.of("none.hdr"));
        Rendering settings = scene.rendering().withSize(48, 32).withIntegrator(Integrator.PATH);
        return scene.withRendering(settings).withLights(lights).withCamera(Camera.of(new Vector3(0, 1, -8), 0, 0, 60));
    }
}
