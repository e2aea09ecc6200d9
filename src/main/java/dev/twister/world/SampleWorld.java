package dev.twister.world;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.SceneGenerator;
import dev.twister.scene.light.Lights;
import dev.twister.scene.select.Title;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;

/** Worlds without files: five spheres on the plane under a plain sky, or a crowd. */
public final class SampleWorld {
    private static final int SKY_WIDTH = 512;
    private static final int SKY_HEIGHT = 256;
    private static final int CHANNELS = 3;
    private static final int SPHERES = 5;
    private static final double SPACING = 4;
    private static final double REFLECTIVITY_STEP = 12;

    private SampleWorld() {}

    /** Five spheres with the default shadow samples and bounces, in the given size in pixels. */
    public static World ofSize(int width, int height) {
        Rendering settings = Rendering.DEFAULT.withSize(width, height);
        Scene scene = Scene.under(Path.of(""))
                .withTitle(new Title("Sample", "Five spheres in a row."))
                .withCamera(Camera.of(new Vector3(0, -5, -15), 0, 7, 50))
                .withLights(Lights.of(Light.of(Vector3.ZERO, 1.2, new Rgb(1, 1, 1))))
                .withGround(Ground.of(48, -9.75, new Rgb(0.4, 0.4, 0.4), new Rgb(0.2, 0.2, 0.2), 32))
                .withSpheres(spheres())
                .withRendering(settings);
        return World.of(scene, new Skybox(SKY_WIDTH, SKY_HEIGHT, gradient()));
    }

    /** A number of spheres on and above a plane, under the same sky, in the given size in pixels. */
    public static World crowd(int spheres, int width, int height) {
        World world = World.of(
                SceneGenerator.spheres(spheres, 1, Path.of("")), new Skybox(SKY_WIDTH, SKY_HEIGHT, gradient()));
        world.setSettings(world.settings().withSize(width, height));
        return world;
    }

    private static List<Sphere> spheres() {
        return IntStream.range(0, SPHERES)
                .mapToObj(index -> Sphere.of(
                        new Vector3((index - SPHERES / 2) * SPACING, -8, 0),
                        1.75,
                        new Rgb(index % 2, 0.5, 1 - index % 2),
                        (index + 1) * REFLECTIVITY_STEP))
                .toList();
    }

    /** Brighter toward the zenith, so that no two rows of texels are equal. */
    private static float[] gradient() {
        float[] radiance = new float[CHANNELS * SKY_WIDTH * SKY_HEIGHT];
        for (int i = 0; i < radiance.length; i++) {
            int row = i / (CHANNELS * SKY_WIDTH);
            radiance[i] = 1 - (float) row / SKY_HEIGHT;
        }
        return radiance;
    }
}
