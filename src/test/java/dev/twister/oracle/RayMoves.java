package dev.twister.oracle;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** A view ray, translated and rotated by a few float roundings, as a rounding engine may compute it. */
final class RayMoves {
    /** Half a unit in the last place of a float at 1. */
    private static final double ROUNDING = 0x1p-24;

    /** A view ray has about five roundings, its hit point as many again, and mirrors amplify them. */
    private static final int[] ROUNDINGS = {2, 8, 32};

    private static final int MOVES_EACH = 24;

    private final List<Vector> steps = new ArrayList<>();

    RayMoves() {
        Random random = new Random(1);
        for (int roundings : ROUNDINGS) {
            for (int i = 0; i < 2 * MOVES_EACH; i++) {
                steps.add(new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                        .normalized()
                        .times(roundings * ROUNDING));
            }
        }
    }

    List<Ray> of(Ray ray) {
        double reach = Math.max(1, ray.origin().length());
        List<Ray> moved = new ArrayList<>();
        for (int i = 0; i < steps.size(); i += 2) {
            moved.add(new Ray(
                    ray.origin().plus(steps.get(i).times(reach)),
                    ray.direction().plus(steps.get(i + 1)).normalized()));
        }
        return moved;
    }
}
