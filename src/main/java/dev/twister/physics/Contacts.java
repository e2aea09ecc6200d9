package dev.twister.physics;

import java.util.Arrays;

/** A growing list of pairs that touch or may come to touch, with the impulses that they have built up. */
final class Contacts {
    /** Impulses for each contact: along the normal, then across it in x, y, z. */
    static final int IMPULSES = 4;

    private static final int[] NO_BODIES = {};
    private static final double[] NO_IMPULSES = {};

    /** The body whose neighbours were looked for; those of one body follow each other. */
    int[] first = NO_BODIES;

    /** The other body, or {@code -1 - k} for surface k of the {@link Surroundings}. */
    int[] second = NO_BODIES;

    /** {@value #IMPULSES} for each contact, in masses times metres a sub-step, as they act on the first body. */
    double[] impulses = NO_IMPULSES;

    int count;

    void clear() {
        count = 0;
    }

    void add(int one, int other) {
        if (count == first.length) {
            int room = Math.max(64, 2 * count);
            first = Arrays.copyOf(first, room);
            second = Arrays.copyOf(second, room);
            impulses = Arrays.copyOf(impulses, IMPULSES * room);
        }
        first[count] = one;
        second[count] = other;
        Arrays.fill(impulses, IMPULSES * count, IMPULSES * (count + 1), 0);
        count++;
    }
}
