package dev.twister.oracle;

import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Scenes lit by several lights. */
public final class RandomLights {
    private RandomLights() {}

    /** The scene with 1 to 4 more lights, above and below the ground, and shares of any size. */
    public static LitScene added(LitScene lit, Random random) {
        Scene scene = lit.scene();
        List<Light> lights = new ArrayList<>();
        lights.add(scene.lights().first().withShare(share(random)));
        int more = 1 + random.nextInt(4);
        for (int i = 0; i < more; i++) {
            Vector3 position = new Vector3(
                    RandomScenes.between(random, -8, 8),
                    RandomScenes.between(random, -2, 8),
                    RandomScenes.between(random, -8, 8));
            Rgb tint = RandomScenes.albedo(random);
            double strength = RandomScenes.between(random, 0, 1.5);
            lights.add(Light.of(
                            position,
                            RandomScenes.extremeOr(random, 0.01, 2, RandomScenes.between(random, 0.1, 1)),
                            new Rgb(strength * tint.red(), strength * tint.green(), strength * tint.blue()))
                    .withShare(share(random)));
        }
        return new LitScene(scene.withLights(new Lights(lights)), lit.images(), lit.meshes());
    }

    /** The scene with a spot as its first light, another one, and a sphere. */
    public static LitScene ofSpots(LitScene lit, Random random) {
        Scene scene = lit.scene();
        Light sphere = scene.lights().first();
        List<Light> lights = List.of(spot(random), spot(random), sphere);
        return new LitScene(scene.withLights(new Lights(lights)), lit.images(), lit.meshes());
    }

    private static Light spot(Random random) {
        Vector3 position = new Vector3(
                RandomScenes.between(random, -6, 6),
                RandomScenes.between(random, 1, 8),
                RandomScenes.between(random, -6, 6));
        Light spot = Light.spot(
                position,
                RandomScenes.between(random, 0.01, 1),
                position.times(-1),
                RandomScenes.between(random, 10, 180));
        return spot.withShape(spot.shape().withConeBlend(RandomScenes.extremeOr(random, 0, 1, random.nextDouble())))
                .withColor(RandomScenes.albedo(random))
                .withShare(share(random));
    }

    /** The scene with a sun as its first light, another one and a sphere. */
    public static LitScene ofSuns(LitScene lit, Random random) {
        Scene scene = lit.scene();
        List<Light> lights = new ArrayList<>();
        lights.add(sun(random, 0));
        lights.add(sun(random, RandomScenes.between(random, 0.2, 20)));
        lights.add(scene.lights().first());
        return new LitScene(scene.withLights(new Lights(lights)), lit.images(), lit.meshes());
    }

    private static Light sun(Random random, double angularDiameterDegrees) {
        Vector3 direction = new Vector3(
                RandomScenes.between(random, -2, 2),
                RandomScenes.between(random, -2, 0.3),
                RandomScenes.between(random, -2, 2));
        return Light.sun(direction, angularDiameterDegrees)
                .withColor(RandomScenes.albedo(random))
                .withShare(share(random));
    }

    private static double share(Random random) {
        return RandomScenes.extremeOr(random, 0, 1, RandomScenes.between(random, 0, 1.5));
    }
}
