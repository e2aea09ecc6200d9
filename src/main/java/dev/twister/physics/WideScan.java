package dev.twister.physics;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The scan of a {@link NeighborGrid} with eight neighbors at once, by the Vector API. It finds the same in the same
 * order; its lanes are no wider than what the grid's arrays have to spare at their ends.
 */
final class WideScan {
    /** Neighbors at once. */
    static final int LANES = 8;

    /** With fewer there is little to gain. */
    static final int MIN_SLOTS = 2500;

    /** So many searches, which are two seconds or less, use it for few slots only, while it is being compiled. */
    static final int FIRST_SEARCHES = 240;

    /** After this number of them it is used for twice as many slots; for one in the first. */
    static final int SEARCHES_TO_DOUBLE = 20;

    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;

    /** Whether the processor has such lanes; only those that have them can pack some of them together. */
    static final boolean SUITS = FloatVector.SPECIES_PREFERRED.equals(FloatVector.SPECIES_512);

    private WideScan() {}

    /**
     * Adds the pairs of a slot's body with those of other slots; their first body is to be set.
     *
     * @param start the first of the others
     * @param end the one after the last
     * @param firstKey the least key of a cell that counts, and how many more do
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
