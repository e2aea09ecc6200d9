package dev.twister.engine.tornado;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneReader;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.World;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whole pictures on every device against {@code sequential}'s. */
class ScenesOnDeviceTest {
    static Stream<Object[]> shippedScenesOnDevices() {
        return Devices.offers().stream()
                .flatMap(offer -> shippedScenes().stream()
                        .map(scene -> new Object[] {scene.getFileName().toString(), scene, offer}));
    }

    static Stream<Object[]> randomWorldsOnDevices() {
        int[] spheres = {0, 1, 2, 5, 9, 17, 24, 40};
        return Devices.offers().stream()
                .flatMap(offer ->
                        Stream.of(0, 1, 2, 3, 4, 5, 6, 7).map(seed -> new Object[] {seed, spheres[seed], offer}));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("shippedScenesOnDevices")
    void shippedSceneLooksTheSame(String name, Path file, EngineOffer offer) {
        Scene scene = SceneReader.read(file);
        World world = World.of(scene, SkyboxReader.read(scene.skybox()));
        // Every ray looks at every sphere, so that many of them get a smaller picture.
        boolean crowded = scene.spheres().size() > 1000;
        world.setSettings(
                crowded ? scene.settings().withSize(64, 36) : scene.settings().withSize(320, 180));
        try (Engine engine = offer.opener().get()) {
            Pictures.requireSequentials(engine, world.snapshot());
        }
    }

    /** Four views of each world, so that one compilation serves them all. */
    @ParameterizedTest(name = "seed {0}, {1} spheres")
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
            Assertions.assertThat(differences)
                    .as("of %d pixels in four pictures", 4 * 64 * 36)
                    .isLessThanOrEqualTo(2);
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
