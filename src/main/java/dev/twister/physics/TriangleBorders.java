package dev.twister.physics;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;

/** Finds triangles that share edges: the positions of their corners are equal. */
final class TriangleBorders {
    private static final int NOTHING = -1;

    private interface Sameness {
        boolean test(int one, int other);
    }

    private TriangleBorders() {}

    /**
     * The neighbors of all triangles.
     *
     * @param corners {@code double[9 * triangles]}
     * @return {@code int[3 * triangles]}: the triangle across the edge from corner k to the next one; -1 if there is
     *     none or more than one
     */
    static int[] neighbors(double[] corners) {
        int count = corners.length / 3;
        int[] vertex = firstAlike(
                count,
                corner -> Arrays.hashCode(new double[] {
                    // Adding 0 turns -0 into 0.
                    corners[3 * corner] + 0.0, corners[3 * corner + 1] + 0.0, corners[3 * corner + 2] + 0.0
                }),
                (one, other) -> corners[3 * one] == corners[3 * other]
                        && corners[3 * one + 1] == corners[3 * other + 1]
                        && corners[3 * one + 2] == corners[3 * other + 2]);
        int[] border = firstAlike(
                count,
                corner -> 31 * Math.min(vertex[corner], vertex[next(corner)])
                        + Math.max(vertex[corner], vertex[next(corner)]),
                (one, other) -> Math.min(vertex[one], vertex[next(one)]) == Math.min(vertex[other], vertex[next(other)])
                        && Math.max(vertex[one], vertex[next(one)]) == Math.max(vertex[other], vertex[next(other)]));
        int[] sharing = new int[count];
        for (int corner = 0; corner < count; corner++) {
            sharing[border[corner]]++;
        }
        int[] neighbors = new int[count];
        Arrays.fill(neighbors, NOTHING);
        for (int corner = 0; corner < count; corner++) {
            int first = border[corner];
            if (first != corner && sharing[first] == 2) {
                neighbors[corner] = first / 3;
                neighbors[first] = corner / 3;
            }
        }
        return neighbors;
    }

    private static int next(int corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    }

    /** For each item, the first equal one; uses a hash table with open addressing. */
    private static int[] firstAlike(int count, IntUnaryOperator hash, Sameness same) {
        int[] table = new int[Integer.highestOneBit(Math.max(1, count)) << 2];
        Arrays.fill(table, NOTHING);
        int[] first = new int[count];
        for (int item = 0; item < count; item++) {
            int mixed = hash.applyAsInt(item) * 0x9E3779B9;
            int slot = (mixed ^ mixed >>> 15) & (table.length - 1);
            while (table[slot] != NOTHING && !same.test(table[slot], item)) {
                slot = (slot + 1) & (table.length - 1);
            }
            table[slot] = table[slot] == NOTHING ? item : table[slot];
            first[item] = table[slot];
        }
        return first;
    }
}
