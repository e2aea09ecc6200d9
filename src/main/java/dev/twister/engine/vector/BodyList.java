package dev.twister.engine.vector;

/** Some of a scene's bodies, in ascending order. */
final class BodyList {
    int[] bodies = new int[16];
    int count;

    void clear() {
        count = 0;
    }

    /** Makes room for so many, so that adding them allocates nothing. */
    void reserve(int most) {
        if (bodies.length < most) {
            bodies = new int[most];
        }
    }

    void add(int body) {
        bodies[count] = body;
        count++;
    }
}
