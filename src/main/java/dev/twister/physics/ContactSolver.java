package dev.twister.physics;

import java.util.function.BiFunction;

/**
 * Contact solver. A contact is either an impact, which is resolved at once by Newton's law of restitution as of the
 * time of the collision, or a resting contact, whose impulse accumulates from sub-step to sub-step so that it carries
 * the load (accumulated impulses: Catto, "Iterative Dynamics with Temporal Coherence", 2005; many small steps instead
 * of many iterations: Macklin et al., "Small Steps in Physics Simulation", 2019). Both have Coulomb friction. Overlaps
 * are corrected slowly by position, without adding speed.
 */
final class ContactSolver {
    /**
     * Distance in the list between contacts that are solved in succession. A body's contacts are adjacent; at this
     * distance they are independent, so the CPU overlaps their work.
     */
    private static final int CONTACTS_APART = 7;

    private final double[] numbers;
    private final Surroundings surroundings;
    private final BiFunction<Surroundings, Double, ContactRules> rulesOf;
    private final PairContact pairs;
    private final SurfaceContact surfaces;
    private ContactRules rules;

    private ContactSolver(
            BodyStore bodies, Surroundings surroundings, BiFunction<Surroundings, Double, ContactRules> rulesOf) {
        numbers = bodies.numbers;
        this.surroundings = surroundings;
        this.rulesOf = rulesOf;
        pairs = new PairContact(bodies, surroundings);
        surfaces = new SurfaceContact(bodies, surroundings);
        rules = rulesOf.apply(surroundings, 0.0);
    }

    /** A solver that moves the bodies of a sub-step. */
    static ContactSolver moving(BodyStore bodies, Surroundings surroundings) {
        return new ContactSolver(bodies, surroundings, ContactRules::moving);
    }

    /** A solver that only finds loads, see {@link ContactRules#bracing}. */
    static ContactSolver bracing(BodyStore bodies, Surroundings surroundings) {
        return new ContactSolver(bodies, surroundings, ContactRules::bracing);
    }

    /** Sets the length of the sub-steps, in seconds. */
    void setSubstep(double seconds) {
        rules = rulesOf.apply(surroundings, seconds);
    }

    /**
     * Solves the contacts of a list.
     *
     * @param from the first contact
     * @param to the index after the last one
     */
    void solve(Contacts contacts, int from, int to) {
        contacts.fetched = fetch(contacts.second, from, to);
        SolvedContact meeting = contacts.meeting;
        meeting.start(contacts.impulses, rules);
        for (int offset = from; offset < from + CONTACTS_APART; offset++) {
            for (int contact = offset; contact < to; contact += CONTACTS_APART) {
                int other = contacts.second[contact];
                int at = Contacts.IMPULSES * contact;
                if (other >= 0) {
                    pairs.solve(meeting, at, contacts.first[contact], other);
                } else {
                    surfaces.solve(meeting, at, contacts.first[contact], -1 - other);
                }
            }
        }
    }

    /**
     * Prefetches every cache line of the second bodies, so that their cache misses overlap. The solver alone would
     * request few at a time: square roots and divisions keep the CPU from running far ahead.
     *
     * @return a value that keeps C2 from eliminating the reads
     */
    private long fetch(int[] second, int from, int to) {
        long bits = 0;
        for (int contact = from; contact < to; contact++) {
            int at = BodyStore.STRIDE * Math.max(0, second[contact]);
            bits += Double.doubleToRawLongBits(numbers[at])
                    + Double.doubleToRawLongBits(numbers[at + BodyStore.STRIDE / 2])
                    + Double.doubleToRawLongBits(numbers[at + BodyStore.STRIDE - 1]);
        }
        return bits;
    }

    /** Solves the unbalanced contacts of a list once. */
    void solveUnbalanced(Contacts contacts) {
        for (int index = 0; index < contacts.unbalancedCount; index++) {
            int contact = contacts.unbalanced[index];
            solve(contacts, contact, contact + 1);
        }
    }
}
