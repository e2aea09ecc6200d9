package dev.twister.bench;

import dev.twister.scene.Scene;
import dev.twister.scene.generate.SceneGenerator;
import dev.twister.sky.Skybox;
import dev.twister.world.World;
import java.nio.file.Path;

/** A small world that renders quickly. */
public final class TestWorld {
    private TestWorld() {}

    public static World create() {
        return World.of(scene(), new Skybox(1, 1, new float[] {0.2f, 0.4f, 0.8f}));
    }

    public static Scene scene() {
        return SceneGenerator.spheres(3, 1, Path.of("sky.hdr"));
    }
}
