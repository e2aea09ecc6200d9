package dev.twister.physics;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * {@link NeighborGrid}'s scan with eight neighbors at a time, by the Vector API. It finds the same pairs in the same
 * order. The grid's arrays have padding for its lanes.
 */
final class WideScan {
    /** Number of neighbors at a time. */
    static final int LANES = 8;

    /** With fewer slots there is little to gain. */
    static final int MIN_SLOTS = 2500;

    /** Number of searches, two seconds or less, during which only some slots use it, while it is being compiled. */
    static final int FIRST_SEARCHES = 240;

    /** Number of searches after which the number of these slots doubles, starting with 1. */
    static final int SEARCHES_TO_DOUBLE = 20;

    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;

    /** Whether the CPU has 512-bit vectors; only these CPUs can compress lanes. */
    static final boolean SUITS = FloatVector.SPECIES_PREFERRED.equals(FloatVector.SPECIES_512);

    private WideScan() {}

    /**
     * Adds the pairs of a slot's body with those of other slots; the caller must set their first body.
     *
     * @param start first of the other slots
     * @param end index after the last one
     * @param firstKey smallest key of an accepted cell
     * @param span number of further keys that are accepted
     */
    static void scan(NeighborGrid grid, int slot, int start, int end, int firstKey, int span, Contacts contacts) {
        float own = Math.abs(grid.reach[slot]);
        float least = grid.reach[slot] > 0 ? Float.NEGATIVE_INFINITY : 0;
        int[] found = contacts.roomFor(end - start + LANES);
        int count = contacts.count;
        for (int other = start; other < end; other += LANES) {
            FloatVector dx = FloatVector.fromArray(FLOATS, grid.x, other).sub(grid.x[slot]);
            FloatVector dy = FloatVector.fromArray(FLOATS, grid.y, other).sub(grid.y[slot]);
            FloatVector dz = FloatVector.fromArray(FLOATS, grid.z, other).sub(grid.z[slot]);
            FloatVector reach = FloatVector.fromArray(FLOATS, grid.reach, other);
            FloatVector sum = reach.abs().add(own);
            FloatVector square = dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz));
            IntVector cell = IntVector.fromArray(INTS, grid.key, other).sub(firstKey);
            long meet = square.compare(VectorOperators.LE, sum.mul(sum)).toLong()
                    & reach.compare(VectorOperators.GT, least).toLong()
                    & cell.compare(VectorOperators.ULE, span).toLong()
                    & ((1L << Math.min(LANES, end - other)) - 1);
            IntVector.fromArray(INTS, grid.body, other)
                    .compress(VectorMask.fromLong(INTS, meet))
                    .intoArray(found, count);
            count += Long.bitCount(meet);
        }
        contacts.addFound(count);
    }
}
