package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.RandomLights;
import dev.twister.oracle.RandomMaterials;
import dev.twister.oracle.RandomMeshes;
import dev.twister.oracle.RandomScenes;
import dev.twister.oracle.SurfacesInOnePlaceTest;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares whole pictures on every device with {@code sequential}'s. */
class ScenesOnDeviceTest {
    static Stream<Object[]> shippedScenesOnDevices() {
        return Devices.namedOffers().stream()
                .flatMap(offer -> shippedScenes().stream().map(scene ->
                        new Object[] {Named.of(scene.getFileName().toString(), scene), offer}));
    }

    static Stream<Object[]> randomWorldsOnDevices() {
        int[] spheres = {0, 1, 2, 5, 9, 31, 50, 80};
        return Devices.namedOffers().stream()
                .flatMap(offer ->
                        Stream.of(0, 1, 2, 3, 4, 5, 6, 7).map(seed -> new Object[] {seed, spheres[seed], offer}));
    }

    @ParameterizedTest(name = "{0} on {1}")
    @MethodSource("shippedScenesOnDevices")
    void shippedSceneLooksTheSame(Path file, EngineOffer offer) {
        Scene scene = SceneReader.read(file);
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
        int height = scene.meshes().isEmpty() ? 180 : 90;
        world.setSettings(scene.rendering().withSize(height * 16 / 9, height));
        try (Engine engine = offer.opener().get()) {
            Pictures.requireSequentials(engine, world.snapshot());
        }
    }

    /** Bit-identical: a hierarchy with all spheres in one leaf is the brute-force loop. */
    @ParameterizedTest(name = "on {0}")
    @MethodSource("offers")
    void hierarchyDrawsWhatThePlainLoopDraws(EngineOffer offer) {
        World world = SceneSamples.world(9, 500);
        world.setSettings(
                Rendering.DEFAULT.withSize(160, 90).withShadowSamples(16).withBounces(3));
        FrameInput input = world.snapshot();
        try (Engine engine = offer.opener().get()) {
            int[] plain = Pictures.of(engine, input.withLeavesOf(input.bodyCount()));
            assertThat(Pictures.of(engine, input)).isEqualTo(plain);
        }
    }

    static List<Named<EngineOffer>> offers() {
        return Devices.namedOffers();
    }

    /** Four views of each world, so that one compilation serves them all. */
    @ParameterizedTest(name = "seed {0}, {1} spheres on {2}")
    @MethodSource("randomWorldsOnDevices")
    void randomWorldLooksTheSame(int seed, int spheres, EngineOffer offer) {
        Random random = new Random(100 + seed);
        World world = SceneSamples.world(seed, spheres);
        try (Engine engine = offer.opener().get()) {
            int differences = 0;
            for (int view = 0; view < 4; view++) {
                world.setCamera(SceneSamples.camera(random));
                world.setSettings(SceneSamples.settings(random, 64, 36));
                differences += Pictures.differences(engine, world.snapshot());
            }
            assertThat(differences)
                    .as("differing pixels of %d in four pictures", 4 * 64 * 36)
                    .isLessThanOrEqualTo(2);
        }
    }

    static Stream<Object[]> randomMaterialsOnDevices() {
        return Devices.namedOffers().stream()
                .flatMap(offer -> Stream.of(0, 1, 2, 3).map(seed -> new Object[] {seed, offer}));
    }

    /** Glass, rough surfaces, textures and lenses, in small pictures of many kinds. */
    @ParameterizedTest(name = "seed {0} on {1}")
    @MethodSource("randomMaterialsOnDevices")
    void randomMaterialsLookTheSame(int seed, EngineOffer offer) {
        Random random = new Random(200 + seed);
        try (Engine engine = offer.opener().get()) {
            int differences = 0;
            int pixels = 0;
            for (int scene = 0; scene < 10; scene++) {
                LitScene lit = RandomMaterials.scene(random, random.nextInt(5));
                FrameInput input = World.of(lit.scene(), lit.images()).snapshot();
                differences += Pictures.differences(engine, input);
                pixels += input.width() * input.rows();
            }
            assertThat(differences).as("of %d pixels in ten pictures", pixels).isLessThanOrEqualTo(2 + pixels / 5000);
        }
    }

    /** Rays that leave one of several surfaces in one place, and glass on a table, without speckles. */
    @ParameterizedTest(name = "on {0}")
    @MethodSource("offers")
    void surfacesInOnePlaceLookTheSame(EngineOffer offer) {
        try (Engine engine = offer.opener().get()) {
            int differences = 0;
            int pixels = 0;
            for (SurfacesInOnePlaceTest.Pair pair :
                    SurfacesInOnePlaceTest.pairs().toList()) {
                FrameInput input = pair.coincident().world().snapshot();
                differences += Pictures.differences(engine, input);
                pixels += input.width() * input.rows();
            }
            assertThat(differences).as("of %d pixels", pixels).isLessThanOrEqualTo(2 + pixels / 5000);
        }
    }

    /** Meshes of all materials, rotated, scaled, mirrored, with no, few and many spheres, in small pictures. */
    @ParameterizedTest(name = "on {0}")
    @MethodSource("offers")
    void randomMeshesLookTheSame(EngineOffer offer) {
        try (Engine engine = offer.opener().get()) {
            int differences = 0;
            int pixels = 0;
            for (int seed : new int[] {0, 5, 13}) {
                Random random = new Random(seed);
                FrameInput input =
                        RandomMeshes.scene(random, random.nextInt(5)).world().snapshot();
                differences += Pictures.differences(engine, input);
                pixels += input.width() * input.rows();
            }
            assertThat(differences).as("of %d pixels in three pictures", pixels).isLessThanOrEqualTo(2 + pixels / 5000);
        }
    }

    /** Several lights over plain bodies, materials and meshes. */
    @ParameterizedTest(name = "on {0}")
    @MethodSource("offers")
    void severalLightsLookTheSame(EngineOffer offer) {
        try (Engine engine = offer.opener().get()) {
            int differences = 0;
            int pixels = 0;
            for (int seed = 0; seed < 3; seed++) {
                Random random = new Random(300 + seed);
                LitScene lit = seed == 0
                        ? RandomScenes.scene(random, 3)
                        : seed == 1 ? RandomMaterials.scene(random, 3) : RandomMeshes.scene(random, 3);
                FrameInput input = RandomLights.added(lit, random).world().snapshot();
                differences += Pictures.differences(engine, input);
                pixels += input.width() * input.rows();
            }
            assertThat(differences).as("of %d pixels in three pictures", pixels).isLessThanOrEqualTo(2 + pixels / 5000);
        }
    }

    /** Suns and spots, with and without path tracing. */
    @ParameterizedTest(name = "on {0}")
    @MethodSource("offers")
    void sunsAndSpotsLookTheSame(EngineOffer offer) {
        try (Engine engine = offer.opener().get()) {
            int differences = 0;
            int pixels = 0;
            for (int seed = 0; seed < 4; seed++) {
                Random random = new Random(400 + seed);
                LitScene lit = seed < 2 ? RandomMaterials.scene(random, 3) : RandomMeshes.scene(random, 3);
                World world =
                        (seed % 2 == 0 ? RandomLights.ofSuns(lit, random) : RandomLights.ofSpots(lit, random)).world();
                for (Integrator integrator : Integrator.values()) {
                    world.setSettings(world.settings().withIntegrator(integrator));
                    FrameInput input = world.snapshot();
                    differences += Pictures.differences(engine, input);
                    pixels += input.width() * input.rows();
                }
            }
            assertThat(differences).as("of %d pixels in eight pictures", pixels).isLessThanOrEqualTo(2 + pixels / 5000);
        }
    }

    private static List<Path> shippedScenes() {
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            return files.filter(file -> file.toString().endsWith(".json")
                            && !file.toString().endsWith(".schema.json"))
                    .sorted()
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
