package dev.twister.oracle;

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
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;

/**
 * Random scenes of hard cases: cameras inside spheres, below the ground and looking straight up, lights inside spheres
 * and touching the ground, touching and overlapping spheres, extremes of every setting, pictures of one pixel, one row
 * and odd sizes. All are small, so that the oracle renders hundreds of them in seconds.
 */
public final class RandomScenes {
    /** Limit of ray-sphere tests by the oracle per picture; picture sizes are reduced to it. */
    private static final double MOST_TESTS = 1.2e7;

    private static final int MOST_PIXELS = 4000;

    private static final List<ToneMap> TONE_MAPS = List.of(ToneMap.values());

    private RandomScenes() {}

    /** Scenes with at most this number of bounces. */
    public static Arbitrary<LitScene> upToBounces(int most) {
        return Arbitraries.randomValue(random -> scene(random, random.nextInt(most + 1)));
    }

    /** Scenes with 4 to 8 bounces, the most in practical use. */
    public static Arbitrary<LitScene> ofManyBounces() {
        return Arbitraries.randomValue(random -> scene(random, 4 + random.nextInt(5)));
    }

    /** Any scene, from one source of randomness; for tests without jqwik. */
    public static LitScene scene(Random random, int bounces) {
        Ground plane = plane(random);
        List<Sphere> spheres = RandomSpheres.spheres(random, plane);
        Light light = light(random, plane, spheres);
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(camera(random, plane, spheres))
                .withLights(Lights.of(light))
                .withGround(plane)
                .withSpheres(spheres)
                .withShading(new Shading(extremeOr(random, 0, 1, random.nextDouble())))
                .withRendering(settings(random, bounces, spheres.size()));
        Skybox sky = RandomSkies.sky(random);
        return new LitScene(
                scene.withSky(scene.sky()
                        .withRotationDegrees(extremeOr(random, 0, -90, between(random, -400, 400)))
                        .withStrength(extremeOr(random, 0, 1, between(random, 0, 3)))),
                sky);
    }

    private static Ground plane(Random random) {
        return Ground.of(
                extremeOr(random, 0.5, 60, between(random, 1, 60)),
                between(random, -3, 1),
                albedo(random),
                albedo(random),
                reflectivity(random));
    }

    private static Light light(Random random, Ground plane, List<Sphere> spheres) {
        double radius = extremeOr(random, 0.01, 4, between(random, 0.1, 2));
        Vector3 above = new Vector3(between(random, -8, 8), between(random, 2, 12), between(random, -8, 8));
        Vector3 position = switch (random.nextInt(8)) {
            case 0 -> new Vector3(above.x(), plane.height() + radius, above.z());
            case 1 -> new Vector3(above.x(), plane.height() - between(random, 0, 4), above.z());
            case 2 -> spheres.isEmpty() ? above : near(random, spheres.getFirst());
            default -> above;
        };
        double strength = extremeOr(random, 0, 1, between(random, 0, 6));
        Rgb tint = albedo(random);
        return Light.of(
                position, radius, new Rgb(strength * tint.red(), strength * tint.green(), strength * tint.blue()));
    }

    private static Camera camera(Random random, Ground plane, List<Sphere> spheres) {
        Vector3 about = new Vector3(between(random, -8, 8), between(random, -1, 8), between(random, -12, 12));
        Vector3 position = switch (random.nextInt(8)) {
            case 0 -> new Vector3(about.x(), plane.height() - between(random, 0.01, 5), about.z());
            case 1 -> spheres.isEmpty() ? about : near(random, spheres.getFirst());
            default -> about;
        };
        double towardsMiddle = Math.toDegrees(Math.atan2(-position.x(), -position.z()));
        return Camera.of(
                position,
                random.nextInt(3) == 0 ? between(random, -400, 400) : towardsMiddle + between(random, -30, 30),
                extremeOr(random, -90, 90, between(random, -20, 60)),
                extremeOr(random, 1, 179, between(random, 15, 120)));
    }

    private static Rendering settings(Random random, int bounces, int spheres) {
        int shadowSamples = extremeOr(random, 1, 500, 1 + random.nextInt(60));
        int samplesPerPixel = Math.max(1, random.nextInt(9) - 3);
        double testsAPixel = samplesPerPixel * (bounces + 1.0) * (2 + spheres) * (shadowSamples + 1);
        int pixels = (int) Math.clamp(MOST_TESTS / testsAPixel, 1, MOST_PIXELS);
        int width = switch (random.nextInt(6)) {
            case 0 -> 1;
            case 1 -> pixels;
            case 2 -> Math.max(1, pixels / 3);
            default -> Math.max(1, (int) (Math.sqrt(pixels) * between(random, 0.5, 2)));
        };
        return Rendering.DEFAULT
                .withSize(width, random.nextInt(20) == 0 ? 1 : Math.max(1, pixels / width))
                .withShadowSamples(shadowSamples)
                .withBounces(bounces)
                .withSamplesPerPixel(samplesPerPixel)
                .withTone(
                        random.nextBoolean() ? 0 : between(random, -4, 4),
                        TONE_MAPS.get(random.nextInt(TONE_MAPS.size())),
                        random.nextBoolean());
    }

    /** A point inside the sphere, but not exactly at its center. */
    static Vector3 near(Random random, Sphere sphere) {
        double reach = 0.5 * sphere.radius();
        return new Vector3(
                sphere.position().x() + between(random, -reach, reach),
                sphere.position().y() + between(random, -reach, reach),
                sphere.position().z() + between(random, -reach, reach));
    }

    static double reflectivity(Random random) {
        return extremeOr(random, 0, 128, between(random, 0, 128));
    }

    static Rgb albedo(Random random) {
        return new Rgb(
                extremeOr(random, 0, 1, random.nextDouble()),
                extremeOr(random, 0, 1, random.nextDouble()),
                extremeOr(random, 0, 1, random.nextDouble()));
    }

    public static double between(Random random, double lowest, double highest) {
        return lowest + (highest - lowest) * random.nextDouble();
    }

    /** Returns each of the two extremes with a probability of 1 in 10. */
    static double extremeOr(Random random, double lowest, double highest, double other) {
        return switch (random.nextInt(10)) {
            case 0 -> lowest;
            case 1 -> highest;
            default -> other;
        };
    }

    private static int extremeOr(Random random, int lowest, int highest, int other) {
        return (int) extremeOr(random, (double) lowest, (double) highest, (double) other);
    }
}
