package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Attenuation;
import dev.twister.scene.material.Emission;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Path-traced pictures are, in the mean, what {@link BruteForce} finds without choosing emitters. */
class BruteForceTest {
    private static final int WIDTH = 16;
    private static final int HEIGHT = 12;
    private static final int SAMPLES = 32;
    private static final int RUNS = 4;
    private static final int BRUTE_SAMPLES = 400;

    /** Of the difference of the means. */
    private static final double MOST_STANDARD_ERRORS = 4;

    private static final Material WHITE = Material.DEFAULT.withColor(new Rgb(0.8, 0.7, 0.6));
    private static final Material GLASS =
            Material.DEFAULT.withColor(new Rgb(0.9, 0.95, 1)).withTransmission(1);

    static Stream<Arguments> materials() {
        return Stream.of(
                Arguments.of("matte", WHITE),
                Arguments.of("half a mirror", WHITE.withReflectivity(64)),
                Arguments.of(
                        "rough metal",
                        WHITE.withReflectivity(128).withMetallic(1).withRoughness(0.6)),
                Arguments.of("metal by Fresnel", WHITE.withMetallic(1).withRoughness(0.5)),
                Arguments.of("half a metal by Fresnel", WHITE.withMetallic(0.5).withRoughness(0.7)),
                Arguments.of("coated", WHITE.withRoughness(0.6)),
                Arguments.of("glass", GLASS),
                Arguments.of("half glass", GLASS.withTransmission(0.5).withReflectivity(20)),
                Arguments.of("frosted glass", GLASS.withRoughness(0.6).withReflectivity(1)),
                Arguments.of(
                        "frosted glass by Fresnel", GLASS.withRoughness(0.6).withIor(2)),
                Arguments.of("a bubble", GLASS.withThinWalled(true)),
                Arguments.of(
                        "a frosted bubble",
                        GLASS.withThinWalled(true).withRoughness(0.5).withTransmission(0.7)),
                Arguments.of("amber", GLASS.withAttenuation(new Attenuation(new Rgb(0.9, 0.6, 0.2), Optional.of(0.7)))),
                Arguments.of("a lamp", WHITE.withEmission(new Emission(new Rgb(1, 2, 3), 0.5, true, LightGroup.NONE))));
    }

    @ParameterizedTest
    @MethodSource("materials")
    void meanIsThatOfBruteForce(String name, Material material) {
        requireMeans(name, scene(material));
    }

    /** Smooth last surfaces show the lights and the sky that they reflect and transmit. */
    @ParameterizedTest
    @CsvSource({"0, 1, 0", "1, 1, 0", "2, 1, 0", "1, 0.5, 20", "1, 0, 64", "0, 0, 128"})
    void pathsOfFewBouncesEndAtLight(int bounces, double transmission, double reflectivity) {
        LitScene lit = scene(GLASS.withTransmission(transmission).withReflectivity(reflectivity));
        Rendering rendering = lit.scene().rendering().withBounces(bounces);
        requireMeans("glass", new LitScene(lit.scene().withRendering(rendering), lit.images(), lit.meshes()));
    }

    @Test
    void lightsAddUp() {
        LitScene lit = scene(WHITE.withReflectivity(20));
        Lights lights = lit.scene()
                .lights()
                .with(List.of(
                        Light.of(new Vector3(2.5, 3, -2), 0.8, new Rgb(0.2, 0.6, 0.3)),
                        Light.of(new Vector3(1.2, 0.5, -1), 0.4, new Rgb(0.9, 0.1, 0.2))
                                .withStrength(2.0)));
        requireMeans("three lights", new LitScene(lit.scene().withLights(lights), lit.images(), lit.meshes()));
    }

    /** Rays spread where they leave a denser body. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.4})
    void aLampInsideGlassLightsWhatIsAround(double roughness) {
        LitScene lit = scene(GLASS.withRoughness(roughness));
        List<Sphere> spheres = new ArrayList<>(lit.scene().spheres());
        spheres.add(Sphere.of(
                new Vector3(0, 1, 0),
                0.3,
                WHITE.withEmission(new Emission(new Rgb(4, 5, 6), 1, true, LightGroup.NONE))));
        requireMeans("a lamp in glass", new LitScene(lit.scene().withSpheres(spheres), lit.images(), lit.meshes()));
    }

    /** A large sun is found by rays that leave surfaces at random, too. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 64})
    void sunsShineAsTheyAreSeen(double reflectivity) {
        LitScene lit = scene(WHITE.withReflectivity(reflectivity));
        Lights lights = lit.scene()
                .lights()
                .with(List.of(Light.sun(new Vector3(0.4, -0.8, 0.5), 20)
                        .withColor(new Rgb(1, 0.8, 0.5))
                        .withStrength(1.5)));
        requireMeans("a sun", new LitScene(lit.scene().withLights(lights), lit.images(), lit.meshes()));
    }

    /** Rays outside of its cone pass a spot, and those inside are stopped by it, on their way to other light, too. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 64})
    void spotsShineInTheirConesAndAreNotSeenOutside(double reflectivity) {
        LitScene lit = scene(WHITE.withReflectivity(reflectivity));
        Light spot = Light.spot(new Vector3(0.9, 1.9, -1.2), 0.5, new Vector3(-0.6, -0.6, 0.8), 100)
                .withColor(new Rgb(1, 0.8, 0.5))
                .withStrength(1.5);
        Lights lights =
                lit.scene().lights().with(List.of(spot.withShape(spot.shape().withConeBlend(0.4))));
        requireMeans("a spot", new LitScene(lit.scene().withLights(lights), lit.images(), lit.meshes()));
    }

    private static void requireMeans(String name, LitScene lit) {
        double[][] brute = brute(lit);
        double[][] traced = traced(lit);
        for (int channel = 0; channel < 3; channel++) {
            double error = Math.hypot(brute[1][channel], traced[1][channel]);
            assertThat(Math.abs(traced[0][channel] - brute[0][channel]))
                    .as("channel %d of %s: %.5f and %.5f", channel, name, traced[0][channel], brute[0][channel])
                    .isLessThan(MOST_STANDARD_ERRORS * error);
        }
    }

    /** A ball over the ground between a large light, a glowing plate of triangles and a sky of two colors. */
    private static LitScene scene(Material material) {
        Path file = Path.of("plate.obj");
        Mesh plate = Mesh.of(file)
                .withPosition(new Vector3(1.6, 1, 0.5))
                .withScale(0.5)
                .withMaterial(WHITE.withEmission(new Emission(new Rgb(2, 1, 0.5), 1, false, LightGroup.NONE)));
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 1.2, -4), 0, 8, 45))
                .withLights(Lights.of(Light.of(new Vector3(-3, 4, -1), 1.5, new Rgb(0.6, 0.5, 0.4))))
                .withGround(Ground.of(20, 0, new Rgb(0.6, 0.6, 0.6), new Rgb(0.3, 0.3, 0.4), 30))
                .withSpheres(List.of(
                        Sphere.of(new Vector3(0, 1, 0), 0.9, material),
                        Sphere.of(new Vector3(-1.3, 0.4, -0.6), 0.4, WHITE)))
                .withMeshes(List.of(plate))
                .withRendering(Rendering.DEFAULT
                        .withSize(WIDTH, HEIGHT)
                        .withBounces(6)
                        .withIntegrator(Integrator.PATH)
                        .withClamp(0));
        Skybox sky =
                new Skybox(2, 2, new float[] {0.4f, 0.6f, 0.9f, 0.5f, 0.5f, 0.5f, 0.2f, 0.1f, 0.1f, 0.3f, 0.2f, 0.1f});
        SceneMeshes meshes = SceneMeshes.of(scene, _ -> MeshShapes.file(MeshShapes.icosphere(0)));
        return new LitScene(scene, SceneImages.of(sky), meshes);
    }

    /** Mean and standard error of each channel. */
    private static double[][] brute(LitScene lit) {
        Scene scene = FloatScene.of(lit.scene());
        List<Body> bodies = new ArrayList<>(OracleTracer.bodies(scene, lit.images(), lit.meshes()));
        Random random = new Random(20261126);
        Set<Body> lights = new HashSet<>();
        for (int index = 0; index < scene.lights().count(); index++) {
            int body = OracleTracer.lightNumber(scene, index);
            if (scene.lights().get(index).isSun()) {
                continue;
            }
            SphereBody light = (SphereBody) bodies.get(body);
            bodies.set(body, new SphereBody(light.center(), light.radius(), radiating(lit, body), light.shape()));
            lights.add(bodies.get(body));
        }
        BruteForce tracer = new BruteForce(
                bodies,
                lights,
                new OracleSky(
                        lit.sky(),
                        0,
                        1,
                        scene.lights().list().stream().filter(Light::isSun).toList()),
                scene.rendering().bounces(),
                random);
        OracleCamera camera = new OracleCamera(scene.camera(), WIDTH, HEIGHT);
        double[][] sums = new double[2][3];
        int count = WIDTH * HEIGHT * BRUTE_SAMPLES;
        for (int i = 0; i < count; i++) {
            int column = i % WIDTH;
            int row = i / WIDTH % HEIGHT;
            ViewRay ray = camera.ray(
                    column + random.nextDouble(), row + random.nextDouble(), new SampleNumbers(column, row, 0));
            Color color = tracer.color(ray.ray());
            add(sums, 0, color.red());
            add(sums, 1, color.green());
            add(sums, 2, color.blue());
        }
        for (int channel = 0; channel < 3; channel++) {
            double mean = sums[0][channel] / count;
            sums[1][channel] = Math.sqrt((sums[1][channel] / count - mean * mean) / count);
            sums[0][channel] = mean;
        }
        return sums;
    }

    private static OracleMaterial radiating(LitScene lit, int body) {
        float[] looks = lit.world().snapshot().bodies().looks();
        int emission = Layout.LOOK_STRIDE * body + Layout.LOOK_EMISSION;
        Rgb radiance = new Rgb(looks[emission], looks[emission + 1], looks[emission + 2]);
        return OracleMaterial.of(
                Material.DEFAULT.withColor(new Rgb(0, 0, 0)).withEmission(Emission.NONE.withColor(radiance)),
                lit.images());
    }

    private static void add(double[][] sums, int channel, double value) {
        sums[0][channel] += value;
        sums[1][channel] += value * value;
    }

    /** As above, by runs of different samples. */
    private static double[][] traced(LitScene lit) {
        FrameInput input = lit.world().snapshot();
        double[][] sums = new double[2][3];
        for (int run = 0; run < RUNS; run++) {
            float[] radiance = Pictures.radiance(JvmEngines.PARALLEL, input.withSamples(run * SAMPLES, SAMPLES));
            double[] means = new double[3];
            for (int i = 0; i < radiance.length; i++) {
                means[i % 3] += radiance[i] / (WIDTH * HEIGHT);
            }
            for (int channel = 0; channel < 3; channel++) {
                add(sums, channel, means[channel]);
            }
        }
        for (int channel = 0; channel < 3; channel++) {
            double mean = sums[0][channel] / RUNS;
            sums[1][channel] = Math.sqrt(Math.max(0, sums[1][channel] / RUNS - mean * mean) / (RUNS - 1));
            sums[0][channel] = mean;
        }
        return sums;
    }
}
