package dev.twister.physics;

/** Passes over all bodies, in chunks for parallel threads, with reduction of the results. */
final class BodyPasses {
    static final int BODIES_AT_ONCE = 4096;

    private static final int FACTS = 7;
    private static final int LONGEST_MOVE_SQUARED = 6;

    /** At the same index, because it is the result of another pass: positive if a body has just woken. */
    private static final int WOKEN = 6;

    private final BodyStore bodies;
    private final Team team;
    private final int firstBody;
    private final double[] bounds = new double[6];
    private double[] facts = {};
    private boolean anyJustWoken;

    BodyPasses(BodyStore bodies, Team team, int firstBody) {
        this.bodies = bodies;
        this.team = team;
        this.firstBody = firstBody;
    }

    /**
     * Stores the bodies' positions before a step, and stops bodies at the limit of the world.
     *
     * @param limit the largest coordinate of the world; bodies that get there stay there
     * @return the largest squared move per sub-step, in m^2; negative if all bodies sleep
     */
    double begin(double limit) {
        double[] longest = look((from, to, at) -> {
            facts[at + LONGEST_MOVE_SQUARED] = begin(from, to, limit);
        });
        double most = -1;
        for (int at = 0; at < longest.length; at += FACTS) {
            most = Math.max(most, longest[at + LONGEST_MOVE_SQUARED]);
        }
        return most;
    }

    /**
     * Wakes roused bodies, and sets the reach of all bodies until the next search.
     *
     * @param margin margin of each body, in its radii
     * @param moves number of sub-steps until then
     * @param fall distance added by gravity until then, in meters
     * @return bounds of the centers: minimum and maximum of x, y and z; overwritten by the next call
     */
    double[] reach(double margin, double moves, double fall) {
        double[] found = look((from, to, at) -> setReach(from, to, at, margin, moves, fall));
        for (int axis = 0; axis < 3; axis++) {
            bounds[2 * axis] = Double.POSITIVE_INFINITY;
            bounds[2 * axis + 1] = Double.NEGATIVE_INFINITY;
            for (int at = 2 * axis; at < found.length; at += FACTS) {
                bounds[2 * axis] = Math.min(bounds[2 * axis], found[at]);
                bounds[2 * axis + 1] = Math.max(bounds[2 * axis + 1], found[at + 1]);
            }
        }
        anyJustWoken = false;
        for (int at = WOKEN; at < found.length; at += FACTS) {
            anyJustWoken |= found[at] > 0;
        }
        return bounds;
    }

    /** Whether any body has just woken ({@link BodyStore#isJustWoken}), as of the last call of {@link #reach}. */
    boolean anyJustWoken() {
        return anyJustWoken;
    }

    private interface Look {
        void at(int from, int to, int facts);
    }

    private double[] look(Look look) {
        int needed = FACTS * Math.ceilDiv(bodies.count - firstBody, BODIES_AT_ONCE);
        if (facts.length != needed) {
            facts = new double[needed];
        }
        team.inChunks(
                firstBody,
                bodies.count,
                BODIES_AT_ONCE,
                (from, to) -> look.at(from, to, FACTS * ((from - firstBody) / BODIES_AT_ONCE)));
        return facts;
    }

    private double begin(int from, int to, double limit) {
        double[] n = bodies.numbers;
        double longest = -1;
        for (int body = from; body < to; body++) {
            int at = BodyStore.STRIDE * body;
            bodies.before[3 * body] = n[at];
            bodies.before[3 * body + 1] = n[at + 1];
            bodies.before[3 * body + 2] = n[at + 2];
            if (Math.abs(n[at]) > limit || Math.abs(n[at + 1]) > limit || Math.abs(n[at + 2]) > limit) {
                bodies.sleep(body);
            }
            if (bodies.state[body] != BodyStore.ASLEEP) {
                longest = Math.max(longest, moveSquared(at));
            }
        }
        return longest;
    }

    private void setReach(int from, int to, int facts0, double margin, double moves, double fall) {
        double[] n = bodies.numbers;
        double woken = 0;
        for (int axis = 0; axis < 3; axis++) {
            facts[facts0 + 2 * axis] = Double.POSITIVE_INFINITY;
            facts[facts0 + 2 * axis + 1] = Double.NEGATIVE_INFINITY;
        }
        for (int body = from; body < to; body++) {
            int at = BodyStore.STRIDE * body;
            double far = n[at + BodyStore.RADIUS] * (1 + margin);
            if (bodies.state[body] != BodyStore.ASLEEP) {
                if (bodies.state[body] == BodyStore.WOKEN) {
                    bodies.state[body] = BodyStore.AWAKE;
                    bodies.free(body);
                }
                woken += bodies.isJustWoken(body) ? 1 : 0;
                far += Math.sqrt(moveSquared(at)) * moves + fall;
            }
            bodies.reach[body] = far;
            for (int axis = 0; axis < 3; axis++) {
                int fact = facts0 + 2 * axis;
                facts[fact] = Math.min(facts[fact], n[at + axis]);
                facts[fact + 1] = Math.max(facts[fact + 1], n[at + axis]);
            }
        }
        facts[facts0 + WOKEN] = woken;
    }

    private double moveSquared(int at) {
        double x = bodies.numbers[at + BodyStore.MOVE];
        double y = bodies.numbers[at + BodyStore.MOVE + 1];
        double z = bodies.numbers[at + BodyStore.MOVE + 2];
        return x * x + y * y + z * z;
    }
}
