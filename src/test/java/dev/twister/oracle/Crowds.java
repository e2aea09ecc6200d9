package dev.twister.oracle;

import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.generate.SceneGenerator;
import dev.twister.sky.Skybox;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Random;

/** Worlds of many spheres. */
public final class Crowds {
    private Crowds() {}

    /** The generator's scene with this number of spheres, soft shadows and interreflections. */
    public static World world(int spheres, int width, int height) {
        Scene scene = SceneGenerator.spheres(spheres, 11, Path.of("none.hdr"));
        Skybox sky = RandomSkies.sky(new Random(11));
        World world = World.of(scene, sky);
        world.setSettings(
                Rendering.DEFAULT.withSize(width, height).withShadowSamples(16).withBounces(3));
        return world;
    }
}
