package dev.twister.physics;

import dev.twister.scene.Vector3;

/**
 * The numbers by which contacts are solved in sub-steps of one length. All speeds are displacements per sub-step.
 *
 * @param gravity change of a free body's move per sub-step
 * @param friction coefficient of Coulomb friction
 * @param elasticity coefficient of restitution
 * @param pushShare share of an overlap that is corrected per sub-step
 * @param mostNewLoad limit of the load that a resting contact may add per sub-step
 * @param impactSpeed slowest impact
 * @param wakeSpeedSquared squared speed per meter of radius that wakes a neighbor
 */
record ContactRules(
        Vector3 gravity,
        double friction,
        double elasticity,
        double pushShare,
        double mostNewLoad,
        double impactSpeed,
        double wakeSpeedSquared) {
    /** Overlap that is not corrected, in radii, so that resting bodies keep touching. */
    static final double SLOP = 0.005;

    /** Before a list is solved. */
    static final ContactRules NONE = new ContactRules(Vector3.ZERO, 0, 0, 0, 0, 0, 0);

    private static final double PUSH_SHARE = 0.2;

    /**
     * In weights of the contact's lighter body, so that a body between a heavy one and the ground gets similar loads
     * from both. The next sub-step solves its warm-start loads in one sweep; whatever that sweep does not take back of
     * a shock's impulse, hundreds of weights, would become speed from nothing.
     */
    private static final double MOST_NEW_LOAD = 8;

    /** For a solver that moves the bodies of a sub-step of a length in seconds. */
    static ContactRules moving(Surroundings surroundings, double seconds) {
        double square = seconds * seconds;
        double strength = surroundings.gravityStrength();
        return new ContactRules(
                surroundings.gravity().times(square),
                surroundings.friction(),
                surroundings.elasticity(),
                PUSH_SHARE,
                MOST_NEW_LOAD * strength * square,
                Rest.impactSpeed(strength) * seconds,
                Rest.wakeSpeedSquared(strength) * square);
    }

    /**
     * For a solver that only finds loads, without limit: it corrects no overlaps, causes no bounces and wakes no
     * bodies.
     */
    static ContactRules bracing(Surroundings surroundings, double seconds) {
        return new ContactRules(
                surroundings.gravity().times(seconds * seconds),
                surroundings.friction(),
                surroundings.elasticity(),
                0,
                Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY);
    }
}
