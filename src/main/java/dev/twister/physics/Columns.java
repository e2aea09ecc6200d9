package dev.twister.physics;

import java.util.Arrays;

/**
 * Bodies in square columns of space, whose rows alternate between two colors. Pairs of one row share no body with pairs
 * of another row of the same color, so rows of one color can be processed by any thread in any order with the same
 * result. Within a row, each column's bodies are still cached when the next column's pairs need them.
 */
final class Columns {
    static final int COLORS = 2;

    /** Most columns per side: enough work for many threads, and few empty columns. */
    private static final int MAX_SIDE = 48;

    private int columnsX;
    private int columnsZ;
    private int[] columnOfSlot = {};
    private int[] starts = {};
    private int[] slots = {};

    /**
     * Sorts all slots except the giants' into columns, in the order of the slots.
     *
     * @param minX with the other three: the bounds of the bodies' centers
     */
    void sort(NeighborGrid grid, double minX, double maxX, double minZ, double maxZ) {
        // A column between two of the same color must separate the pairs of both.
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

    /** Number of rows of a color. */
    int rows(int color) {
        return (columnsZ + 1 - color) / COLORS;
    }

    /** The number of a color's row among all rows. */
    int row(int color, int index) {
        return COLORS * index + color;
    }

    /** The first column of a row; the others follow. */
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
