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
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Emission;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Path-traced pictures of scenes that are hard on arithmetic. */
class PathPixelsTest {
    private static final int SCENES = 1000;
    private static final Material GLASS = Material.DEFAULT.withTransmission(1);

    @Test
    void everyPixelOfRandomScenesIsANumberFromZeroOn() {
        ShownWorld world = new ShownWorld();
        for (int seed = 0; seed < SCENES; seed++) {
            float[] radiance = Pictures.radiance(JvmEngines.SEQUENTIAL, world.input(scene(new Random(seed))));
            for (float value : radiance) {
                assertThat(value >= 0 && value < Float.POSITIVE_INFINITY)
                        .as("scene %d has %s", seed, value)
                        .isTrue();
            }
        }
    }

    private static LitScene scene(Random random) {
        LitScene any = random.nextBoolean()
                ? RandomMaterials.scene(random, random.nextInt(8))
                : RandomMeshes.scene(random, random.nextInt(8));
        LitScene lit = random.nextInt(3) == 0 ? RandomLights.added(any, random) : any;
        Scene scene = emitting(lit.scene(), random);
        Rendering settings = scene.rendering()
                .withIntegrator(Integrator.PATH)
                .withClamp(random.nextBoolean() ? 0 : 10)
                .withSamplesPerPixel(2)
                .withSize(8, 6);
        Scene seen = scene.withRendering(settings).withCamera(camera(scene, random));
        SceneImages images =
                new SceneImages(sky(lit.sky(), random), lit.images().textureByFile());
        return new LitScene(seen, images, lit.meshes());
    }

    /** The scene with some bodies that emit, and some of glass. */
    private static Scene emitting(Scene scene, Random random) {
        return scene.withSpheres(scene.spheres().stream()
                        .map(sphere -> sphere.withMaterial(changed(sphere.material(), random)))
                        .toList())
                .withMeshes(scene.meshes().stream()
                        .map(mesh -> mesh.material()
                                .map(own -> changed(own, random))
                                .map(mesh::withMaterial)
                                .orElse(mesh))
                        .toList());
    }

    private static Material changed(Material material, Random random) {
        double strength = RandomScenes.extremeOr(random, 0, 1e6, RandomScenes.between(random, 0, 20));
        return switch (random.nextInt(4)) {
            case 0 ->
                material.withEmission(
                        new Emission(RandomScenes.albedo(random), strength, random.nextBoolean(), LightGroup.NONE));
            case 1 -> GLASS.withRoughness(RandomScenes.extremeOr(random, 0, 1, random.nextDouble()));
            case 2 ->
                material.withReflectivity(0)
                        .withMetallic(RandomScenes.extremeOr(random, 0, 1, random.nextDouble()))
                        .withRoughness(RandomScenes.extremeOr(random, 0, 1, random.nextDouble()));
            default -> material;
        };
    }

    /** Where the scene has it, or inside a light or a sphere. */
    private static Camera camera(Scene scene, Random random) {
        return switch (random.nextInt(4)) {
            case 0 -> scene.camera().withPosition(scene.lights().first().position());
            case 1 ->
                scene.spheres().isEmpty()
                        ? scene.camera()
                        : scene.camera().withPosition(scene.spheres().getFirst().position());
            default -> scene.camera();
        };
    }

    /** The scene's own, a black one, or one with a texel as bright as a file can have it. */
    private static Skybox sky(Skybox own, Random random) {
        float[] texels = new float[3 * 8 * 4];
        return switch (random.nextInt(4)) {
            case 0 -> new Skybox(8, 4, texels);
            case 1 -> {
                texels[3 * random.nextInt(8 * 4) + 1] = 1e30f;
                yield new Skybox(8, 4, texels);
            }
            default -> own;
        };
    }

    @Test
    void aWhiteSkyIsWhiteFromTheMiddleOfAGlassBall() {
        Scene scene = alone(Light.of(new Vector3(0, -600, 0), 1, new Rgb(0, 0, 0)))
                .withSpheres(List.of(Sphere.of(Vector3.ZERO, 2, GLASS)));

        assertThat(radiance(scene, 1)).containsExactly(ones(), within(1e-3f));
    }

    @Test
    void aClampLimitsTheLuminanceAndLeavesTheHue() {
        Scene scene = alone(Light.of(new Vector3(0, -600, 0), 1, new Rgb(0, 0, 0)))
                .withSpheres(List.of(Sphere.of(Vector3.ZERO, 2, GLASS), Sphere.of(Vector3.ZERO, 3, GLASS)));
        Skybox warm = new Skybox(1, 1, new float[] {40, 20, 10});
        double kept = 5 / (0.2126 * 40 + 0.7152 * 20 + 0.0722 * 10);

        float[] radiance = Pictures.radiance(
                JvmEngines.SEQUENTIAL, scene.withRendering(scene.rendering().withClamp(5)), warm);

        for (int channel = 0; channel < radiance.length; channel++) {
            assertThat((double) radiance[channel]).isCloseTo(kept * warm.radiance()[channel % 3], within(1e-3));
        }
    }

    @Test
    void aLightIsNotSeenFromInside() {
        Scene scene = alone(Light.of(Vector3.ZERO, 2, new Rgb(5, 5, 5)));

        assertThat(radiance(scene, 1)).containsOnly(1f);
    }

    @Test
    void aGroundThatTurnsItsBackOnTheLightIsBlack() {
        Scene scene = alone(Light.of(new Vector3(0, -5, 0), 1, new Rgb(5, 5, 5)))
                .withGround(Ground.of(100, -1, new Rgb(1, 1, 1), new Rgb(1, 1, 1), 0))
                .withCamera(Camera.of(Vector3.ZERO, 0, 60, 30));

        assertThat(radiance(scene, 0)).containsOnly(0f);
    }

    private static float[] ones() {
        float[] ones = new float[3 * 8 * 6];
        Arrays.fill(ones, 1);
        return ones;
    }

    /** Nothing but a light, and a ground that is far below it. */
    private static Scene alone(Light light) {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(Vector3.ZERO, 0, 0, 60))
                .withGround(Ground.of(1, -500, new Rgb(0, 0, 0), new Rgb(0, 0, 0), 0))
                .withLights(Lights.of(light))
                .withRendering(Rendering.DEFAULT
                        .withSize(8, 6)
                        .withBounces(50)
                        .withSamplesPerPixel(4)
                        .withIntegrator(Integrator.PATH));
    }

    private static float[] radiance(Scene scene, float sky) {
        return Pictures.radiance(JvmEngines.SEQUENTIAL, scene, new Skybox(1, 1, new float[] {sky, sky, sky}));
    }
}
