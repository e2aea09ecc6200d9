package dev.twister.physics;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;

/** A growing list of pairs that touch or may come to touch, with the impulses that they have built up. */
final class Contacts {
    /** Impulses for each contact: the whole one in x, y, z, then its share along the normal. */
    static final int IMPULSES = 4;

    /**
     * Where among them that share is: below 0 where the lighter body is as firm as the ground, and bears nothing of it.
     */
    static final int BUILT = 3;

    private static final int LEAST_ROOM = 64;

    private static final int[] NO_BODIES = {};
    private static final double[] NO_IMPULSES = {};

    /** The body whose neighbors were looked for; those of one body follow each other. */
    int[] first = NO_BODIES;

    /** The other body, or {@code -1 - k} for surface k of the {@link Surroundings}. */
    int[] second = NO_BODIES;

    /** {@value #IMPULSES} for each contact, in masses times meters a sub-step, as they act on the first body. */
    double[] impulses = NO_IMPULSES;

    int count;

    /** Where no more are looked for. */
    private int limit = Integer.MAX_VALUE;

    /** The contacts of bodies that have just woken. */
    int[] unbalanced = NO_BODIES;

    int unbalancedCount;

    /** Written by the solver, and read by no one. */
    long fetched;

    void clear() {
        count = 0;
        unbalancedCount = 0;
    }

    /** Says how many more may be looked for. */
    void limit(int more) {
        limit = count + more;
    }

    void unlimited() {
        limit = Integer.MAX_VALUE;
    }

    boolean isFull() {
        return count >= limit;
    }

    /** Adds a contact; its first body and its impulses are to be set. */
    void add(int other) {
        reserve(1);
        second[count] = other;
        count++;
    }

    /** Where the other bodies of pairs are to be written, from {@link #count} on: there is room for as many more. */
    int[] roomFor(int more) {
        reserve(more);
        return second;
    }

    /** Adds the pairs with those that were written; their first body and their impulses are to be set. */
    void addFound(int newCount) {
        count = newCount;
    }

    /** Says whose the contacts from one on are. */
    void setFirst(int one, int from) {
        Arrays.fill(first, from, count, one);
    }

    /**
     * Takes over an earlier list's impulses, contact by contact, as long as the other bodies are the same.
     *
     * @param from the first contact here, and likewise there
     * @param to the one after the last here, and likewise there
     * @return how many contacts are the same
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

    /** Says that a contact is one of a body that has just woken. */
    void addUnbalanced(int contact) {
        if (unbalancedCount == unbalanced.length) {
            unbalanced = Arrays.copyOf(unbalanced, Math.max(LEAST_ROOM, 2 * unbalancedCount));
        }
        unbalanced[unbalancedCount] = contact;
        unbalancedCount++;
    }

    /** Keeps those of the pairs from one on whose other body is wanted. */
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
     * Keeps the pairs from one on that are smallest by a measure, at most that number, in their present order.
     *
     * @param measure of the other body, at least 0
     */
    void keepLeast(int from, int most, IntToDoubleFunction measure) {
        long[] least = new long[count - from];
        for (int index = 0; index < least.length; index++) {
            float size = (float) measure.applyAsDouble(second[from + index]);
            // Floats that are not below 0 sort as their bits do.
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
