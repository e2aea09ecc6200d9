package dev.twister.world;

import dev.twister.kernel.Layout;
import java.util.Random;

/**
 * Spheres that look for trouble: tiny and huge, near and a million metres away, apart, in one another, in one place, on a
 * line and on a grid whose centres tie.
 *
 * @param positions {@code float[3 * bodies]}, of a light, a plane and the spheres
 * @param sizes {@code float[bodies]}
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record RandomCrowds(float[] positions, float[] sizes) {
    /** So many spheres of one of the kinds. */
    public static RandomCrowds of(Random random, int spheres) {
        float[] positions = new float[3 * (Layout.FIRST_SPHERE + spheres)];
        float[] sizes = new float[Layout.FIRST_SPHERE + spheres];
        positions[1] = 20;
        sizes[Layout.LIGHT] = 1;
        positions[3 * Layout.PLANE + 1] = -4;
        sizes[Layout.PLANE] = 40;
        int kind = random.nextInt(7);
        double reach = Math.pow(10, -2 + 4 * random.nextDouble());
        for (int body = Layout.FIRST_SPHERE; body < sizes.length; body++) {
            for (int axis = 0; axis < 3; axis++) {
                positions[3 * body + axis] = (float) coordinate(random, kind, axis, body, reach);
            }
            sizes[body] = (float)
                    (kind == 5
                            ? Math.pow(10, -6 + 9 * random.nextDouble())
                            : reach * Math.pow(10, -3 + 2.5 * random.nextDouble()));
        }
        return new RandomCrowds(positions, sizes);
    }

    private static double coordinate(Random random, int kind, int axis, int body, double reach) {
        return switch (kind) {
            case 0 -> 3; // all in one place
            case 1 -> axis == body % 3 ? reach * random.nextGaussian() : 0;
            case 2 -> reach * random.nextInt(4); // ties
            case 3 -> (random.nextInt(4) == 0 ? 1e6 : 1) * random.nextGaussian();
            case 4 -> Math.pow(2, -body % 60) * (axis + 1); // each half as far: the deepest trees
            default -> reach * random.nextGaussian();
        };
    }
}
