package dev.twister.physics;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;

/** A growing list of pairs in contact or near it, with their accumulated impulses. */
final class Contacts {
    /** Doubles per contact: the impulse's x, y and z, then its component along the normal. */
    static final int IMPULSES = 4;

    /** Offset of that component. It is negative if the lighter body is as firm as the ground and carries none of it. */
    static final int BUILT = 3;

    private static final int LEAST_ROOM = 64;

    private static final int[] NO_BODIES = {};
    private static final double[] NO_IMPULSES = {};

    /** The body whose neighbors were searched; the contacts of one body are contiguous. */
    int[] first = NO_BODIES;

    /** The other body, or {@code -1 - k} for surface k of the {@link Surroundings}. */
    int[] second = NO_BODIES;

    /** {@value #IMPULSES} doubles per contact, in masses times meters per sub-step, acting on the first body. */
    double[] impulses = NO_IMPULSES;

    int count;

    /** Number of contacts at which a search stops. */
    private int limit = Integer.MAX_VALUE;

    /** The contacts of bodies that have just woken. */
    int[] unbalanced = NO_BODIES;

    int unbalancedCount;

    /** The contact that is being solved. */
    final SolvedContact meeting = new SolvedContact(NO_IMPULSES, ContactRules.NONE);

    /** Sink for the solver's prefetch reads; keeps C2 from eliminating them. */
    long fetched;

    void clear() {
        count = 0;
        unbalancedCount = 0;
    }

    /** Limits the number of further contacts. */
    void limit(int more) {
        limit = count + more;
    }

    void unlimited() {
        limit = Integer.MAX_VALUE;
    }

    boolean isFull() {
        return count >= limit;
    }

    /** Adds a contact; the caller must set its first body and impulses. */
    void add(int other) {
        reserve(1);
        second[count] = other;
        count++;
    }

    /** The array for the other bodies of new pairs, with room for {@code more} from {@link #count} on. */
    int[] roomFor(int more) {
        reserve(more);
        return second;
    }

    /** Adds the pairs whose other bodies were written; the caller must set their first body and impulses. */
    void addFound(int newCount) {
        count = newCount;
    }

    /** Sets the first body of the contacts from {@code from} on. */
    void setFirst(int one, int from) {
        Arrays.fill(first, from, count, one);
    }

    /**
     * Copies an earlier list's impulses, contact by contact, as long as the other bodies are equal.
     *
     * @param from first contact here; earlierFrom there
     * @param to index after the last contact here; earlierTo there
     * @return the number of equal contacts
     */
    int inheritWhileAlike(int from, int to, Contacts earlier, int earlierFrom, int earlierTo) {
        int most = Math.min(to - from, earlierTo - earlierFrom);
        int alike = 0;
        while (alike < most && second[from + alike] == earlier.second[earlierFrom + alike]) {
            int own = IMPULSES * (from + alike);
            int old = IMPULSES * (earlierFrom + alike);
            impulses[own] = earlier.impulses[old];
            impulses[own + 1] = earlier.impulses[old + 1];
            impulses[own + 2] = earlier.impulses[old + 2];
            impulses[own + BUILT] = earlier.impulses[old + BUILT];
            alike++;
        }
        return alike;
    }

    /** Lists a contact of a body that has just woken. */
    void addUnbalanced(int contact) {
        if (unbalancedCount == unbalanced.length) {
            unbalanced = Arrays.copyOf(unbalanced, Math.max(LEAST_ROOM, 2 * unbalancedCount));
        }
        unbalanced[unbalancedCount] = contact;
        unbalancedCount++;
    }

    /** Keeps only those pairs from {@code from} on whose other body is wanted. */
    void keep(int from, IntPredicate wanted) {
        int kept = from;
        for (int contact = from; contact < count; contact++) {
            if (wanted.test(second[contact])) {
                second[kept] = second[contact];
                kept++;
            }
        }
        count = kept;
    }

    /**
     * Keeps at most {@code most} of the pairs from {@code from} on, those with the smallest measure, in their order.
     *
     * @param measure a value of the other body, at least 0
     */
    void keepLeast(int from, int most, IntToDoubleFunction measure) {
        long[] least = new long[count - from];
        for (int index = 0; index < least.length; index++) {
            float size = (float) measure.applyAsDouble(second[from + index]);
            // Non-negative floats sort like their bits.
            least[index] = (long) Float.floatToRawIntBits(size) << Integer.SIZE | index;
        }
        Arrays.sort(least);
        int[] kept = new int[Math.min(most, least.length)];
        for (int index = 0; index < kept.length; index++) {
            kept[index] = (int) least[index];
        }
        Arrays.sort(kept);
        for (int index = 0; index < kept.length; index++) {
            second[from + index] = second[from + kept[index]];
        }
        count = from + kept.length;
    }

    private void reserve(int more) {
        if (count + more > first.length) {
            int room = Math.max(LEAST_ROOM, 2 * (count + more));
            first = Arrays.copyOf(first, room);
            second = Arrays.copyOf(second, room);
            impulses = Arrays.copyOf(impulses, IMPULSES * room);
        }
    }
}
