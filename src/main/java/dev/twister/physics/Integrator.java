package dev.twister.physics;

import dev.twister.scene.Vector3;

/**
 * Störmer's and Verlet's method, with the drag in the middle of the step: {@code x[n+1] = x[n] + (1 - c h / 2) / (1 + c
 * h / 2) (x[n] - x[n-1]) + a h^2 / (1 + c h / 2)}, of second order, exact without drag (Hairer, Lubich and Wanner,
 * "Geometric numerical integration illustrated by the Störmer-Verlet method", 2003).
 */
final class Integrator {
    /**
     * The most that a body's contacts may carry of it into the next sub-step, in its weights: at rest they carry one. A
     * small sphere between a heavy one and the ground has thousands of weights on both sides; where one side's impulse
     * comes late, the difference would shoot it away.
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

    Integrator(BodyStore bodies, Surroundings surroundings) {
        this.bodies = bodies;
        this.surroundings = surroundings;
        Vector3 up = surroundings.up();
        upX = up.x();
        upY = up.y();
        upZ = up.z();
    }

    /** Says how long the sub-steps are from now on, in seconds. */
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

    /** What a body moves before its first sub-step so that it starts with a velocity, on one axis. */
    double moveBefore(double velocity, double gravity) {
        return velocity * seconds - gravity * seconds * seconds / 2;
    }

    /**
     * Turns the moves of sub-steps of another length into those of the present one.
     *
     * @param old that length, in seconds
     */
    void rescale(int from, int to, double old) {
        double ratio = seconds / old;
        Vector3 gravity = surroundings.gravity();
        // A move is the velocity half a sub-step ago; with other sub-steps that was at another time.
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

    /** The first half of a sub-step: the moves to come, before any contact has a say. */
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
                boolean held = Backing.holdsUp(n[by] * upX + n[by + 1] * upY + n[by + 2] * upZ, length, weight);
                bodies.held[body] = (byte) (held ? Backing.MOMENT : Math.max(0, bodies.held[body] - 1));
                // What has just woken is braced at once.
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

    /** The second half of a sub-step. */
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
