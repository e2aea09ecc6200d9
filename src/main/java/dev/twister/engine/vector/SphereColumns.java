package dev.twister.engine.vector;

/** Spheres side by side, with as many blanks behind as one load may reach too far; grows, never shrinks. */
final class SphereColumns {
    float[] x = {};
    float[] y = {};
    float[] z = {};
    float[] radius = {};

    /** The spheres' numbers among the bodies: whole, and exact in a float. */
    float[] body = {};

    int count;

    /** Makes room for so many; what was in the columns is lost where they grow. */
    void reserve(int most) {
        if (x.length < most + Lanes.COUNT) {
            x = new float[most + Lanes.COUNT];
            y = new float[most + Lanes.COUNT];
            z = new float[most + Lanes.COUNT];
            radius = new float[most + Lanes.COUNT];
            body = new float[most + Lanes.COUNT];
        }
    }

    /** Adds some of the other columns' spheres: one bit each, from {@code first} on. */
    void add(SphereColumns from, int first, long lanes) {
        Lanes.pack(from.x, first, lanes, x, count);
        Lanes.pack(from.y, first, lanes, y, count);
        Lanes.pack(from.z, first, lanes, z, count);
        Lanes.pack(from.radius, first, lanes, radius, count);
        Lanes.pack(from.body, first, lanes, body, count);
        count += Long.bitCount(lanes);
    }
}
