package dev.twister.engine.vector.lanes;

import java.util.Arrays;

/**
 * Spheres side by side in columns of one array: what is known of the sphere at a place lies there and so many times
 * {@link #stride} further on. Some lanes behind a column's last sphere may be read, and mean nothing.
 */
public final class SphereColumns {
    /** By how many strides the facts of a sphere lie behind its x. */
    public static final int Y = 1;

    public static final int Z = 2;
    public static final int RADIUS = 3;

    /** The sphere's number among the bodies: whole, and exact in a float. */
    public static final int BODY = 4;

    public static final int COLUMNS = 5;

    /** Where the first sphere's x lies. */
    public static final int FIRST = Lanes.BORDER;

    public float[] values = {};

    /** From one column to the next. */
    public int stride;

    /** From one packet of spheres to the next. */
    public int step;

    /** Where, in blocks, the number of the sphere among the bodies lies whose number along the blocks that is. */
    public static int bodyPlace(int sphere) {
        return FIRST + (sphere / Lanes.COUNT * COLUMNS + BODY) * Lanes.COUNT + sphere % Lanes.COUNT;
    }

    /**
     * Makes room for that number of spheres, one column whole behind the other; what was there is lost where they grow.
     */
    public void reserveList(int most) {
        if (stride < most + Lanes.COUNT) {
            stride = most + Lanes.COUNT;
            step = Lanes.COUNT;
            values = new float[FIRST + COLUMNS * stride];
        }
    }

    /** Makes room for that number of blocks of {@link Lanes#COUNT} spheres; what is there stays. */
    public void reserveBlocks(int most) {
        stride = Lanes.COUNT;
        step = COLUMNS * Lanes.COUNT;
        if (values.length < FIRST + most * step) {
            values = Arrays.copyOf(values, FIRST + 2 * most * step);
        }
    }

    /**
     * Copies some spheres of others, close together; room is needed for one packet more.
     *
     * @param to the place of the first
     * @param from the place of the others' first
     * @param lanes one bit a sphere that is copied
     */
    public void copy(int to, SphereColumns others, int from, long lanes) {
        for (int column = 0; column < COLUMNS; column++) {
            Lanes.pack(others.values, from + column * others.stride, lanes, values, to + column * stride);
        }
    }
}
