package dev.twister.scene.generate;

import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Thousands of spheres in Vogel's sunflower order, lifted into spiral waves about one large mirror. Vogel's order keeps
 * neighbors about equally far apart however many there are, so none touches another.
 */
final class SphereVortex {
    /** The radius of the disc that holds the spheres, in meters. */
    static final double DISC_RADIUS = 40;

    static final double MIRROR_RADIUS = 4.5;

    private static final double HOLE_RADIUS = 6.5;
    static final double GOLDEN_ANGLE = Math.PI * (3 - StrictMath.sqrt(5));

    /** Neighbors are more than 1.5 spacings apart, found by trying all; half of that, less a gap, is the most. */
    static final double MAX_RADIUS_IN_SPACINGS = 0.72;

    private final int count;
    private final double spacing;
    private final double firstIndex;
    private final Palette palette;
    private final int arms;
    private final double wavesOutward;
    private final double phase;
    private final Random random;

    private SphereVortex(int count, long seed) {
        this.count = count;
        random = new Random(seed);
        palette = Palette.ALL.get(random.nextInt(Palette.ALL.size()));
        arms = 3 + random.nextInt(3);
        wavesOutward = 2.2 + 0.8 * random.nextDouble();
        phase = 2 * Math.PI * random.nextDouble();
        // Indices start where the hole ends: spacing * sqrt(firstIndex) = hole, spacing * sqrt(firstIndex + count) =
        // disc.
        double holeShare = HOLE_RADIUS * HOLE_RADIUS / (DISC_RADIUS * DISC_RADIUS);
        firstIndex = count * holeShare / (1 - holeShare);
        spacing = DISC_RADIUS / StrictMath.sqrt(firstIndex + count);
    }

    /** Returns the spheres over the ground at y = 0, none touching another, the mirror first */
    static List<Sphere> spheres(int count, long seed) {
        return new SphereVortex(count, seed).all();
    }

    private List<Sphere> all() {
        List<Sphere> spheres = new ArrayList<>(count);
        spheres.add(
                Rounding.of(Sphere.of(new Vector3(0, MIRROR_RADIUS, 0), MIRROR_RADIUS, new Rgb(0.97, 0.97, 1), 124)));
        for (int i = 1; i < count; i++) {
            spheres.add(sphere(i));
        }
        return spheres;
    }

    private Sphere sphere(int i) {
        double outward = spacing * StrictMath.sqrt(firstIndex + i);
        double angle = i * GOLDEN_ANGLE;
        double share = outward / DISC_RADIUS;
        double wave = 0.5 + 0.5 * StrictMath.cos(2 * Math.PI * wavesOutward * share - arms * angle + phase);
        double radius = spacing * MAX_RADIUS_IN_SPACINGS * (0.5 + 0.4 * wave + 0.1 * random.nextDouble());
        double lift = 4.5 * wave * wave * StrictMath.sqrt(share);
        Rgb color = palette.at(0.12 + 0.72 * wave + 0.16 * random.nextDouble() * share);
        double reflectivity = random.nextInt(12) == 0 ? 72 + 40 * random.nextDouble() : 6 + 26 * wave;
        Vector3 position = new Vector3(outward * StrictMath.cos(angle), radius + lift, outward * StrictMath.sin(angle));
        return Rounding.of(Sphere.of(position, radius, color, reflectivity));
    }
}
