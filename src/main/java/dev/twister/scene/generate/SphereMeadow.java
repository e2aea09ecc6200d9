package dev.twister.scene.generate;

import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Up to some hundred spheres strewn over a disc on the ground about three large ones, after the cover of Shirley's "Ray
 * Tracing in One Weekend".
 */
final class SphereMeadow {
    private static final int TRIES_PER_GROWTH = 200;
    private static final double GAP = 0.05;

    private final Random random;
    private final Palette palette;
    private final int count;
    private final double discRadius;
    private final List<Sphere> spheres = new ArrayList<>();

    private SphereMeadow(int count, long seed) {
        random = new Random(seed);
        palette = Palette.ALL.get(random.nextInt(Palette.ALL.size()));
        this.count = count;
        discRadius = discRadius(count);
    }

    /** The radius of the disc that holds the spheres, in meters. */
    static double discRadius(int count) {
        return 2 + 0.85 * Math.sqrt(count);
    }

    /** Returns the spheres, resting on the ground at y = 0, none touching another */
    static List<Sphere> spheres(int count, long seed) {
        return new SphereMeadow(count, seed).grow();
    }

    private List<Sphere> grow() {
        double large = 0.155 * discRadius;
        List<Sphere> heroes = List.of(
                resting(0, 0, large, new Rgb(0.96, 0.96, 0.98), 120),
                resting(-2.35 * large, 0.75 * large, 0.9 * large, palette.at(0.62), 20),
                resting(2.35 * large, 0.5 * large, 0.95 * large, new Rgb(1, 0.78, 0.36), 84));
        spheres.addAll(heroes.subList(0, Math.min(count, heroes.size())));
        while (spheres.size() < count) {
            strew();
        }
        return List.copyOf(spheres);
    }

    // Darts are thrown until one lands clear of all others; the disc grows where it is full.
    private void strew() {
        double radius = 0.26 + 0.42 * StrictMath.pow(random.nextDouble(), 2);
        double reach = discRadius;
        Sphere dart;
        int tries = 0;
        do {
            double angle = 2 * Math.PI * random.nextDouble();
            double distance = reach * StrictMath.sqrt(random.nextDouble());
            dart = resting(
                    distance * StrictMath.cos(angle), distance * StrictMath.sin(angle), radius, color(), gloss());
            tries++;
            reach *= tries % TRIES_PER_GROWTH == 0 ? 1.05 : 1;
        } while (!isClear(dart));
        spheres.add(dart);
    }

    private boolean isClear(Sphere dart) {
        return spheres.stream().allMatch(sphere -> {
            Vector3 apart = sphere.position().minus(dart.position());
            double least = sphere.radius() + dart.radius() + GAP;
            return apart.dot(apart) > least * least;
        });
    }

    private Rgb color() {
        Rgb base = palette.at(random.nextDouble());
        return Palette.mix(base, new Rgb(1, 1, 1), 0.25 * random.nextDouble());
    }

    // Two in three are dull, one in four shines, the rest are nearly mirrors.
    private double gloss() {
        double kind = random.nextDouble();
        double within = random.nextDouble();
        if (kind < 0.65) {
            return 4 + 12 * within;
        }
        return kind < 0.9 ? 24 + 32 * within : 90 + 38 * within;
    }

    private static Sphere resting(double x, double z, double radius, Rgb color, double reflectivity) {
        double rounded = Rounding.of(radius);
        return Rounding.of(Sphere.of(new Vector3(x, rounded, z), rounded, color, reflectivity));
    }
}
