package dev.twister.physics;

import dev.twister.scene.Vector3;

/**
 * Says which small bodies give way to what presses them, and which cannot: one that is pressed against the ground, a
 * wall or others that hold it is as firm as they are, however little it weighs. Without that, a heavy body would sink
 * into a small one as long as the small one's contacts take to build up its weight, which is seconds at thousands to
 * one.
 */
final class Backing {
    /** How near a surface is to count, in radii. */
    private static final double NEAR = 0.1;

    /** The cosine of the largest angle between a push and what holds against it; beyond, a body slips away. */
    private static final double LEAST_COSINE = Math.sqrt(0.5);

    /** The least load that shows that a body lies on others, in its weights. */
    private static final double LEAST_LOAD = 0.5;

    /** How long what held a body counts on: what lies on others bounces a little. */
    static final int MOMENT = 4;

    private final BodyStore bodies;
    private final Surroundings surroundings;
    private final Vector3 up;

    Backing(BodyStore bodies, Surroundings surroundings) {
        this.bodies = bodies;
        this.surroundings = surroundings;
        up = surroundings.up();
    }

    /**
     * Whether the contacts of a body hold it up.
     *
     * @param lift what they add to its move against gravity
     * @param all the length of what they add to it
     * @param weight what gravity adds to it
     */
    static boolean holdsUp(double lift, double all, double weight) {
        return lift > LEAST_LOAD * weight && lift >= LEAST_COSINE * all;
    }

    /**
     * Says that a body is at something firm.
     *
     * @param nx and the other two: the normal, towards the body
     * @param gap between them, in radii of the smaller one
     */
    void touch(int body, double nx, double ny, double nz, double gap) {
        if (gap <= NEAR && nx * up.x() + ny * up.y() + nz * up.z() >= LEAST_COSINE) {
            bodies.held[body] = MOMENT;
        }
    }

    /** Whether a body that is awake cannot give way along a unit vector. */
    boolean holds(int body, double dx, double dy, double dz) {
        boolean lies = bodies.held[body] > 0 && -(dx * up.x() + dy * up.y() + dz * up.z()) >= LEAST_COSINE;
        return lies || sunk(body, dx, dy, dz) >= -NEAR * bodies.numbers[BodyStore.STRIDE * body + BodyStore.RADIUS];
    }

    /**
     * How deep a body is in the ground or the wall that holds it along a unit vector, in meters: below 0 before it,
     * less the body's radius where there is none.
     */
    double sunk(int body, double dx, double dy, double dz) {
        double[] n = bodies.numbers;
        int at = BodyStore.STRIDE * body;
        double radius = n[at + BodyStore.RADIUS];
        double sunk = -radius;
        int side = bodies.side[body];
        if (-side * dy >= LEAST_COSINE && surroundings.isOver(n[at], n[at + 2])) {
            sunk = radius - side * (n[at + 1] - surroundings.height());
        }
        if (bodies.walled[body]) {
            for (int wall = 0; wall < Surroundings.WALLS; wall++) {
                if (surroundings.towardsWall(wall, dx, dz) >= LEAST_COSINE) {
                    double place = surroundings.towardsWall(wall, n[at], n[at + 2]);
                    sunk = Math.max(sunk, radius - surroundings.halfSide() + place);
                }
            }
        }
        return sunk;
    }
}
