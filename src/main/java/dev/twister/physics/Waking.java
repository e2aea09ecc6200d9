package dev.twister.physics;

/** Wakes sleeping bodies that a moving one comes near. */
final class Waking {
    /** Gap in radii within which a moving body wakes a sleeping one. */
    private static final double GAP = 0.1;

    private final BodyStore bodies;
    private final double[] numbers;

    Waking(BodyStore bodies) {
        this.bodies = bodies;
        numbers = bodies.numbers;
    }

    /**
     * Wakes each of two bodies if the other one is near and fast.
     *
     * @param square squared distance of their centers
     * @param radii sum of their radii
     */
    void wake(int one, int two, double square, double radii, double speedSquared) {
        double near = (1 + GAP) * radii;
        if (square < near * near) {
            wakeBy(one, two, speedSquared);
            wakeBy(two, one, speedSquared);
        }
    }

    private void wakeBy(int sleeper, int mover, double wakeSpeedSquared) {
        int at = BodyStore.STRIDE * mover + BodyStore.MOVE;
        double speedSquared =
                numbers[at] * numbers[at] + numbers[at + 1] * numbers[at + 1] + numbers[at + 2] * numbers[at + 2];
        boolean hit = speedSquared > wakeSpeedSquared * numbers[BodyStore.STRIDE * sleeper + BodyStore.RADIUS];
        if (hit && bodies.state[sleeper] == BodyStore.ASLEEP && !bodies.isLight(sleeper)) {
            bodies.rouse(sleeper);
        }
    }

    /** A body's inverse mass as if it were awake. */
    double inverseMassAwake(int body) {
        return bodies.isLight(body) ? 0 : bodies.inverseMass(numbers[BodyStore.STRIDE * body + BodyStore.RADIUS]);
    }

    /** The inverse mass in an impact of the body whose values start at an index: a roused body moves at once. */
    double inverseMassWhenHit(int at) {
        int body = at / BodyStore.STRIDE;
        if (numbers[at + BodyStore.INVERSE_MASS] == 0 && bodies.state[body] == BodyStore.WOKEN) {
            bodies.free(body);
        }
        return numbers[at + BodyStore.INVERSE_MASS];
    }
}
