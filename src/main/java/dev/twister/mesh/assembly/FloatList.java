package dev.twister.mesh.assembly;

import java.util.Arrays;

/** A growing list of floats. */
public final class FloatList {
    private float[] values;
    private int size;

    public FloatList(int capacity) {
        values = new float[Math.max(16, capacity)];
    }

    public FloatList() {
        this(0);
    }

    public int size() {
        return size;
    }

    public float get(int index) {
        return values[index];
    }

    void set(int index, float value) {
        values[index] = value;
    }

    public void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, Math.addExact(size, size >> 1));
        }
        values[size++] = value;
    }

    /** The internal array, which is longer than the list; do not keep a reference to it. */
    float[] storage() {
        return values;
    }

    public float[] toArray() {
        return size == values.length ? values : Arrays.copyOf(values, size);
    }
}
