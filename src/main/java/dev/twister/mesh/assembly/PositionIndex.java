package dev.twister.mesh.assembly;

import java.util.Arrays;

/** Assigns numbers to positions; equal positions get the same number. */
public final class PositionIndex {
    private final DoubleList positions;
    private int[] table = new int[1 << 10];

    /** Starts without positions; new ones are added to this empty list. */
    public PositionIndex(DoubleList positions) {
        this.positions = positions;
        Arrays.fill(table, -1);
    }

    /** The number of a position, which is added if it is new. */
    public int of(double x, double y, double z) {
        int count = positions.size() / 3;
        if (2 * count >= table.length) {
            grow(count);
        }
        int slot = slot(x, y, z);
        if (table[slot] >= 0) {
            return table[slot];
        }
        table[slot] = count;
        positions.add(x);
        positions.add(y);
        positions.add(z);
        return count;
    }

    private void grow(int count) {
        table = new int[2 * table.length];
        Arrays.fill(table, -1);
        for (int i = 0; i < count; i++) {
            table[slot(positions.get(3 * i), positions.get(3 * i + 1), positions.get(3 * i + 2))] = i;
        }
    }

    private int slot(double x, double y, double z) {
        int mask = table.length - 1;
        int slot = TableHash.of(bits(x), bits(y), bits(z)) & mask;
        while (table[slot] >= 0 && !isAt(table[slot], x, y, z)) {
            slot = slot + 1 & mask;
        }
        return slot;
    }

    private boolean isAt(int index, double x, double y, double z) {
        return positions.get(3 * index) == x && positions.get(3 * index + 1) == y && positions.get(3 * index + 2) == z;
    }

    // Adding 0 turns -0 into 0, which is equal to it.
    private static int bits(double value) {
        return Double.hashCode(value + 0.0);
    }
}
