package dev.twister.physics;

/** Thresholds of rest, relative to the strength of gravity, so that scenes of different size behave alike. */
final class Rest {
    /** Duration of a fall in seconds whose speed is the slowest impact; slower contacts do not bounce. */
    private static final double IMPACT_SECONDS = 0.01;

    /** Largest speed that is calm, relative to that of a fall through the radius. */
    private static final double CALM_SHARE = 0.02;

    /** How many times faster than calm a neighbor must be to wake a body. */
    private static final double WAKE_FACTOR = 4;

    /** How long a body must be calm before it sleeps. */
    static final double CALM_SECONDS = 0.5;

    private Rest() {}

    /** Slowest impact, in m/s. */
    static double impactSpeed(double gravity) {
        return IMPACT_SECONDS * gravity;
    }

    /** Squared speed limit of calm per meter of radius, in m^2/s^2. */
    static double calmSpeedSquared(double gravity) {
        return CALM_SHARE * CALM_SHARE * gravity;
    }

    /** Squared speed limit for waking per meter of radius, in m^2/s^2. */
    static double wakeSpeedSquared(double gravity) {
        return WAKE_FACTOR * WAKE_FACTOR * calmSpeedSquared(gravity);
    }

    /** After a step of the given length, puts bodies to sleep that have been calm on others for long enough. */
    static void settle(BodyStore bodies, int from, int to, double gravity, double seconds) {
        double[] n = bodies.numbers;
        double calm = calmSpeedSquared(gravity) * seconds * seconds;
        int enough = (int) Math.ceil(CALM_SECONDS / seconds);
        for (int body = from; body < to; body++) {
            if (bodies.state[body] == BodyStore.AWAKE) {
                int at = BodyStore.STRIDE * body;
                double x = n[at] - bodies.before[3 * body];
                double y = n[at + 1] - bodies.before[3 * body + 1];
                double z = n[at + 2] - bodies.before[3 * body + 2];
                boolean still = x * x + y * y + z * z <= calm * n[at + BodyStore.RADIUS];
                boolean supported = n[at + BodyStore.SUPPORT] != 0
                        || n[at + BodyStore.SUPPORT + 1] != 0
                        || n[at + BodyStore.SUPPORT + 2] != 0;
                bodies.calmSteps[body] = still && supported ? bodies.calmSteps[body] + 1 : 0;
                if (bodies.calmSteps[body] >= enough) {
                    bodies.sleep(body);
                }
            }
        }
    }
}
