package dev.twister.physics;

import java.util.Arrays;

/**
 * The bodies in square columns of space, in rows of two colors by turns: what is done to the pairs of one row touches
 * no body that the pairs of another one of the same color touch. So rows of one color go to any threads in any order
 * and the result is the same. Along a row each column's bodies are still in the cache when the next one's pairs need
 * them.
 */
final class Columns {
    static final int COLORS = 2;

    /** As many a side at most: there is work for many threads, and few columns without any. */
    private static final int MAX_SIDE = 48;

    private int columnsX;
    private int columnsZ;
    private int[] columnOfSlot = {};
    private int[] starts = {};
    private int[] slots = {};

    /**
     * Puts all slots but the giants' into columns, each in the order of the slots.
     *
     * @param minX and the other three: where the bodies' centers are
     */
    void sort(NeighborGrid grid, double minX, double maxX, double minZ, double maxZ) {
        // A column between two of one color has to keep the pairs of both apart.
        double least = 2 * grid.farthestPair();
        double widthX = Math.max(least, (maxX - minX) / MAX_SIDE);
        double widthZ = Math.max(least, (maxZ - minZ) / MAX_SIDE);
        columnsX = side(minX, maxX, widthX);
        columnsZ = side(minZ, maxZ, widthZ);
        int columns = columnsX * columnsZ;
        if (columnOfSlot.length < grid.slots) {
            columnOfSlot = new int[grid.slots];
            slots = new int[grid.slots];
        }
        if (starts.length < columns + 1) {
            starts = new int[columns + 1];
        }
        Arrays.fill(starts, 0);
        for (int slot = 0; slot < grid.slots; slot++) {
            int column = -1;
            if (!grid.isGiant(slot)) {
                int cx = index(grid.x[slot], minX, widthX, columnsX);
                int cz = index(grid.z[slot], minZ, widthZ, columnsZ);
                column = cz * columnsX + cx;
                starts[column + 1]++;
            }
            columnOfSlot[slot] = column;
        }
        for (int column = 0; column < columns; column++) {
            starts[column + 1] += starts[column];
        }
        int sorted = starts[columns];
        for (int slot = grid.slots - 1; slot >= 0; slot--) {
            if (columnOfSlot[slot] >= 0) {
                slots[--starts[columnOfSlot[slot] + 1]] = slot;
            }
        }
        System.arraycopy(starts, 1, starts, 0, columns);
        starts[columns] = sorted;
    }

    private static int side(double min, double max, double width) {
        return (int) Math.clamp(Math.floor((max - min) / width) + 1, 1, MAX_SIDE);
    }

    private static int index(double place, double min, double width, int columns) {
        return (int) Math.clamp((place - min) / width, 0, columns - 1);
    }

    int count() {
        return columnsX * columnsZ;
    }

    int rows() {
        return columnsZ;
    }

    /** How many rows of columns a color has. */
    int rows(int color) {
        return (columnsZ + 1 - color) / COLORS;
    }

    /** The number, among all rows, of one of a color. */
    int row(int color, int index) {
        return COLORS * index + color;
    }

    /** The first column of a row; the others follow it. */
    int firstOfRow(int row) {
        return row * columnsX;
    }

    int columnsInRow() {
        return columnsX;
    }

    int start(int column) {
        return starts[column];
    }

    int end(int column) {
        return starts[column + 1];
    }

    int slot(int index) {
        return slots[index];
    }
}
