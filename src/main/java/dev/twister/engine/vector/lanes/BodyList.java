package dev.twister.engine.vector.lanes;

/** A list of bodies in ascending order. */
public final class BodyList {
    public int[] bodies = new int[16];
    public int count;

    public void clear() {
        count = 0;
    }

    /** Allocates room for that number of bodies. */
    public void reserve(int most) {
        if (bodies.length < most) {
            bodies = new int[most];
        }
    }

    public void add(int body) {
        bodies[count] = body;
        count++;
    }
}
