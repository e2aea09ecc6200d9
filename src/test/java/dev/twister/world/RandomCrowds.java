package dev.twister.world;

import dev.twister.kernel.Layout;
import java.util.Random;

/**
 * Spheres that are hard cases for hierarchies: tiny and huge, near and a million meters away, apart, nested,
 * concentric, on a line, and on a grid with tied centers.
 *
 * @param places a light, a plane and the spheres, in the layout of {@link Bodies}
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record RandomCrowds(float[] places) {
    /** Creates this number of spheres of a random kind. */
    public static RandomCrowds of(Random random, int spheres) {
        int bodies = Layout.FIRST_SPHERE + spheres;
        float[] places = new float[Layout.PLACE_STRIDE * bodies];
        places[1] = 20;
        places[Layout.PLACE_SIZE] = 1;
        places[Layout.PLACE_STRIDE * Layout.PLANE + 1] = -4;
        places[Layout.PLACE_STRIDE * Layout.PLANE + Layout.PLACE_SIZE] = 40;
        int kind = random.nextInt(7);
        double reach = Math.pow(10, -2 + 4 * random.nextDouble());
        for (int body = Layout.FIRST_SPHERE; body < bodies; body++) {
            int place = Layout.PLACE_STRIDE * body;
            for (int axis = 0; axis < 3; axis++) {
                places[place + axis] = (float) coordinate(random, kind, axis, body, reach);
            }
            places[place + Layout.PLACE_SIZE] = (float)
                    (kind == 5
                            ? Math.pow(10, -6 + 9 * random.nextDouble())
                            : reach * Math.pow(10, -3 + 2.5 * random.nextDouble()));
        }
        return new RandomCrowds(places);
    }

    /** Returns the number of bodies: light, plane and spheres. */
    public int bodies() {
        return places.length / Layout.PLACE_STRIDE;
    }

    /** Returns a sphere's radius. */
    public float radius(int body) {
        return places[Layout.PLACE_STRIDE * body + Layout.PLACE_SIZE];
    }

    /** Returns a coordinate of a body's center: 0 for x, 1 for y, 2 for z. */
    public float center(int body, int axis) {
        return places[Layout.PLACE_STRIDE * body + axis];
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
