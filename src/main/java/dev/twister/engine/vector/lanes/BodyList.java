package dev.twister.engine.vector.lanes;

/** Some of a scene's bodies, in ascending order. */
public final class BodyList {
    public int[] bodies = new int[16];
    public int count;

    public void clear() {
        count = 0;
    }

    /** Makes room for that number, so that adding them allocates nothing. */
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
