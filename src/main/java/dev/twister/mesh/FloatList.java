package dev.twister.mesh;

import java.util.Arrays;

/** A growing list of floats. */
final class FloatList {
    private float[] values;
    private int size;

    FloatList(int capacity) {
        values = new float[Math.max(16, capacity)];
    }

    FloatList() {
        this(0);
    }

    int size() {
        return size;
    }

    float get(int index) {
        return values[index];
    }

    void set(int index, float value) {
        values[index] = value;
    }

    void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, Math.addExact(size, size >> 1));
        }
        values[size++] = value;
    }

    /** The internal array, which is longer than the list; do not keep a reference to it. */
    float[] storage() {
        return values;
    }

    float[] toArray() {
        return size == values.length ? values : Arrays.copyOf(values, size);
    }
}
