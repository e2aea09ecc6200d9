package dev.twister.mesh.assembly;

import java.util.Arrays;

/** A growing list of ints. */
public final class IntList {
    private int[] values;
    private int size;

    public IntList(int capacity) {
        values = new int[Math.max(16, capacity)];
    }

    public IntList() {
        this(0);
    }

    public int size() {
        return size;
    }

    public int get(int index) {
        return values[index];
    }

    void set(int index, int value) {
        values[index] = value;
    }

    public void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, Math.addExact(size, size >> 1));
        }
        values[size++] = value;
    }

    /** Truncates the list to a length. */
    public void cut(int newSize) {
        size = newSize;
    }

    /** The internal array, which is longer than the list; do not keep a reference to it. */
    int[] storage() {
        return values;
    }

    public int[] toArray() {
        return size == values.length ? values : Arrays.copyOf(values, size);
    }
}
