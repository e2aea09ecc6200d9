package dev.twister.engine.tornado;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Random worlds, reproducible by their seed. */
final class SceneSamples {
    private SceneSamples() {}

    static World world(long seed, int spheres) {
        return world(seed, spheres, sky(new Random(seed)));
    }

    static World world(long seed, int spheres, Skybox sky) {
        Random random = new Random(seed);
        List<Sphere> bodies = new ArrayList<>();
        for (int i = 0; i < spheres; i++) {
            double reflectivity = i % 4 == 0 ? 128 * (i / 4 % 2) : 128 * random.nextDouble();
            bodies.add(Sphere.of(place(random, 8), 0.2 + 2.5 * random.nextDouble(), color(random), reflectivity));
        }
        Light light = Light.of(place(random, 10), 0.1 + 2 * random.nextDouble(), new Rgb(1, 0.9, 0.8));
        Ground plane = Ground.of(48, -6, color(random), color(random), 128 * random.nextDouble());
        Scene scene = Scene.under(Path.of("none"))
                .withCamera(camera(random))
                .withLights(Lights.of(light))
                .withGround(plane)
                .withSpheres(bodies)
                .withShading(new Shading(0.2));
        return World.of(scene, sky);
    }

    /** Near the bodies, among them, or straight above or below. */
    static Camera camera(Random random) {
        double pitch = random.nextInt(6) == 0 ? 90 * (random.nextInt(3) - 1) : 60 * random.nextDouble() - 20;
        double fieldOfView = random.nextInt(8) == 0 ? 1 + 178 * random.nextInt(2) : 20 + 100 * random.nextDouble();
        return Camera.of(place(random, 12), 360 * random.nextDouble(), pitch, fieldOfView);
    }

    static Rendering settings(Random random, int width, int height) {
        int[] samples = {1, 2, 16, 64, 200};
        ToneMap[] toneMaps = ToneMap.values();
        return Rendering.DEFAULT
                .withSize(width, height)
                .withShadowSamples(samples[random.nextInt(samples.length)])
                .withBounces(random.nextInt(9))
                .withSamplesPerPixel(1 + random.nextInt(3))
                .withTone(random.nextInt(3) - 1, toneMaps[random.nextInt(toneMaps.length)], random.nextBoolean());
    }

    private static Skybox sky(Random random) {
        float[] radiance = new float[3 * 16 * 8];
        for (int i = 0; i < radiance.length; i++) {
            radiance[i] = 1.5f * random.nextFloat();
        }
        return new Skybox(16, 8, radiance);
    }

    private static Vector3 place(Random random, double reach) {
        return new Vector3(
                reach * (2 * random.nextDouble() - 1),
                reach * (1.5 * random.nextDouble() - 0.5),
                reach * (2 * random.nextDouble() - 1));
    }

    private static Rgb color(Random random) {
        return new Rgb(random.nextDouble(), random.nextDouble(), random.nextDouble());
    }
}
