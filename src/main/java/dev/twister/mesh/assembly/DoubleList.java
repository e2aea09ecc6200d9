package dev.twister.mesh.assembly;

import java.util.Arrays;

/** A growing list of doubles. */
final class DoubleList {
    private double[] values;
    private int size;

    DoubleList(int capacity) {
        values = new double[Math.max(16, capacity)];
    }

    DoubleList() {
        this(0);
    }

    int size() {
        return size;
    }

    double get(int index) {
        return values[index];
    }

    void add(double value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, Math.addExact(size, size >> 1));
        }
        values[size++] = value;
    }
}
