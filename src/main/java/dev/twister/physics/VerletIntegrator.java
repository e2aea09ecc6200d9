package dev.twister.physics;

import dev.twister.scene.Vector3;

/**
 * The Störmer-Verlet method with drag in the middle of the step: {@code x[n+1] = x[n] + (1 - c h / 2) / (1 + c h / 2)
 * (x[n] - x[n-1]) + a h^2 / (1 + c h / 2)}. It has order 2 and is exact in free fall without drag (Hairer, Lubich and
 * Wanner, "Geometric numerical integration illustrated by the Störmer-Verlet method", 2003).
 */
final class VerletIntegrator {
    /**
     * Limit of a body's warm-started contact impulses, in its weights; at rest they are 1. A small sphere between a
     * heavy one and the ground has thousands of weights on both sides; if one side's impulse came late, the difference
     * would eject it.
     */
    private static final double MOST_SUPPORT = 64;

    private final BodyStore bodies;
    private final Surroundings surroundings;
    private double seconds;
    private double kept;
    private double gravityX;
    private double gravityY;
    private double gravityZ;
    private double longestMove;
    private double mostSupport;
    private double weight;
    private final double upX;
    private final double upY;
    private final double upZ;

    VerletIntegrator(BodyStore bodies, Surroundings surroundings) {
        this.bodies = bodies;
        this.surroundings = surroundings;
        Vector3 up = surroundings.up();
        upX = up.x();
        upY = up.y();
        upZ = up.z();
    }

    /** Sets the length of the sub-steps, in seconds. */
    void setSubstep(double newSeconds) {
        seconds = newSeconds;
        double half = surroundings.damping() * seconds / 2;
        kept = (1 - half) / (1 + half);
        double square = seconds * seconds / (1 + half);
        Vector3 gravity = surroundings.gravity();
        gravityX = gravity.x() * square;
        gravityY = gravity.y() * square;
        gravityZ = gravity.z() * square;
        longestMove = Simulation.MAX_SPEED * seconds;
        weight = surroundings.gravityStrength() * seconds * seconds;
        mostSupport = MOST_SUPPORT * weight;
    }

    /** Component of a body's displacement before its first sub-step, for a start velocity along one axis. */
    double moveBefore(double velocity, double gravity) {
        return velocity * seconds - gravity * seconds * seconds / 2;
    }

    /**
     * Converts the moves from an earlier length of the sub-steps to the current one.
     *
     * @param old the earlier length in seconds
     */
    void rescale(int from, int to, double old) {
        double ratio = seconds / old;
        Vector3 gravity = surroundings.gravity();
        // A move is the velocity half a sub-step ago, so its time depends on the length of the sub-steps.
        double later = (old - seconds) / 2 * seconds;
        for (int body = from; body < to; body++) {
            int at = BodyStore.STRIDE * body;
            boolean falling = bodies.state[body] != BodyStore.ASLEEP && isUnsupported(at);
            double change = falling ? later : 0;
            scale(at + BodyStore.MOVE, ratio, gravity.x() * change);
            scale(at + BodyStore.MOVE + 1, ratio, gravity.y() * change);
            scale(at + BodyStore.MOVE + 2, ratio, gravity.z() * change);
            scale(at + BodyStore.SUPPORT, ratio * ratio, 0);
            scale(at + BodyStore.SUPPORT + 1, ratio * ratio, 0);
            scale(at + BodyStore.SUPPORT + 2, ratio * ratio, 0);
        }
    }

    /** First half of a sub-step: computes the moves without new contact impulses. */
    void accelerate(int from, int to) {
        double[] n = bodies.numbers;
        for (int body = from; body < to; body++) {
            byte state = bodies.state[body];
            if (state == BodyStore.AWAKE) {
                int at = BodyStore.STRIDE * body + BodyStore.MOVE;
                int by = BodyStore.STRIDE * body + BodyStore.SUPPORT;
                double support = n[by] * n[by] + n[by + 1] * n[by + 1] + n[by + 2] * n[by + 2];
                double length = Math.sqrt(support);
                n[at - BodyStore.MOVE + BodyStore.CARRIED] = length;
                boolean held = Firmness.holdsUp(n[by] * upX + n[by + 1] * upY + n[by + 2] * upZ, length, weight);
                bodies.held[body] = (byte) (held ? Firmness.MOMENT : Math.max(0, bodies.held[body] - 1));
                // Woken bodies are braced right away.
                double carried = length > mostSupport && !bodies.isJustWoken(body) ? mostSupport / length : 1;
                double x = kept * n[at] + gravityX + carried * n[by];
                double y = kept * n[at + 1] + gravityY + carried * n[by + 1];
                double z = kept * n[at + 2] + gravityZ + carried * n[by + 2];
                double square = x * x + y * y + z * z;
                if (square > longestMove * longestMove) {
                    double scale = longestMove / Math.sqrt(square);
                    x *= scale;
                    y *= scale;
                    z *= scale;
                }
                n[at] = x;
                n[at + 1] = y;
                n[at + 2] = z;
                n[by] = 0;
                n[by + 1] = 0;
                n[by + 2] = 0;
            } else if (state == BodyStore.WOKEN) {
                int at = BodyStore.STRIDE * body + BodyStore.SUPPORT;
                n[at] = 0;
                n[at + 1] = 0;
                n[at + 2] = 0;
                bodies.held[body] = 0;
            }
        }
    }

    /** Second half of a sub-step: applies the moves. */
    void move(int from, int to) {
        double[] n = bodies.numbers;
        for (int body = from; body < to; body++) {
            if (bodies.state[body] != BodyStore.ASLEEP) {
                int at = BodyStore.STRIDE * body;
                n[at] += n[at + BodyStore.MOVE];
                n[at + 1] += n[at + BodyStore.MOVE + 1];
                n[at + 2] += n[at + BodyStore.MOVE + 2];
            }
        }
    }

    private boolean isUnsupported(int at) {
        double[] n = bodies.numbers;
        return n[at + BodyStore.SUPPORT] == 0
                && n[at + BodyStore.SUPPORT + 1] == 0
                && n[at + BodyStore.SUPPORT + 2] == 0;
    }

    private void scale(int at, double factor, double added) {
        bodies.numbers[at] = bodies.numbers[at] * factor + added;
    }
}
