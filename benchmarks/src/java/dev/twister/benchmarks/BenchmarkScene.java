package dev.twister.benchmarks;

import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.generate.SceneGenerator;
import dev.twister.world.SceneImages;
import dev.twister.world.World;
import java.nio.file.Path;

/** The scenes that are measured. */
final class BenchmarkScene {
    /** Where the checkout is; the Maven profile says so. */
    private static final Path HOME = Path.of(System.getProperty("twister.home", "."));

    private static final long SEED = 1;

    private BenchmarkScene() {}

    /** The paper's scene. */
    static World paper(Rendering settings) {
        return world(SceneReader.read(HOME.resolve("scenes/benchmark.json")), settings);
    }

    /** The paper's scene for five spheres, else a generated one. */
    static World withSpheres(int spheres, Rendering settings) {
        return spheres == 5
                ? paper(settings)
                : world(SceneGenerator.spheres(spheres, SEED, HOME.resolve("skyboxes/day.hdr")), settings);
    }

    private static World world(Scene scene, Rendering settings) {
        World world = World.of(scene, SceneImages.read(scene, _ -> {}));
        world.setSettings(settings);
        return world;
    }
}
