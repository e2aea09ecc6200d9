package dev.twister.physics;

import dev.twister.scene.Vector3;

/**
 * Decides which small bodies yield to a push and which cannot. A body that is pressed against the ground, a wall or
 * bodies that hold it is as firm as these, however light it is. Otherwise a heavy body would sink into a small one
 * until the small one's contacts have accumulated its weight, which takes seconds at mass ratios of thousands.
 */
final class Firmness {
    /** Distance in radii within which a surface counts. */
    private static final double NEAR = 0.1;

    /** Cosine of the largest angle between a push and a support against it; at larger angles a body slips away. */
    private static final double LEAST_COSINE = Math.sqrt(0.5);

    /** Smallest load, in weights of the body, that shows that it rests on others. */
    private static final double LEAST_LOAD = 0.5;

    /** Number of sub-steps for which a support keeps counting, because resting bodies bounce slightly. */
    static final int MOMENT = 4;

    private final BodyStore bodies;
    private final Surroundings surroundings;
    private final Vector3 up;

    Firmness(BodyStore bodies, Surroundings surroundings) {
        this.bodies = bodies;
        this.surroundings = surroundings;
        up = surroundings.up();
    }

    /**
     * Whether the contacts of a body hold it up.
     *
     * @param lift the part of their change of its move that is directed against gravity
     * @param all the length of their change of its move
     * @param weight the length of gravity's change of its move
     */
    static boolean holdsUp(double lift, double all, double weight) {
        return lift > LEAST_LOAD * weight && lift >= LEAST_COSINE * all;
    }

    /**
     * Records that a body touches something firm.
     *
     * @param nx with ny and nz: the normal, toward the body
     * @param gap the gap between them, in radii of the smaller one
     */
    void touch(int body, double nx, double ny, double nz, double gap) {
        if (gap <= NEAR && nx * up.x() + ny * up.y() + nz * up.z() >= LEAST_COSINE) {
            bodies.held[body] = MOMENT;
        }
    }

    /** Whether an awake body cannot yield along a unit vector. */
    boolean holds(int body, double dx, double dy, double dz) {
        boolean lies = bodies.held[body] > 0 && -(dx * up.x() + dy * up.y() + dz * up.z()) >= LEAST_COSINE;
        return lies || sunk(body, dx, dy, dz) >= -NEAR * bodies.numbers[BodyStore.STRIDE * body + BodyStore.RADIUS];
    }

    /**
     * How deep a body is in the ground or wall that holds it along a unit vector, in meters. Negative with a gap; minus
     * the radius if there is neither.
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
