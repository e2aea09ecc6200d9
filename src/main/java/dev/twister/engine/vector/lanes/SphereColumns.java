package dev.twister.engine.vector.lanes;

import java.util.Arrays;

/**
 * Spheres in columns of one array: a sphere's values are at its place plus multiples of {@link #stride}. Lanes after a
 * column's last sphere may be read; their values are meaningless.
 */
public final class SphereColumns {
    /** Offsets of a sphere's values from its x, in strides. */
    public static final int Y = 1;

    public static final int Z = 2;
    public static final int RADIUS = 3;

    /** The sphere's body number, an integer that is exact as a float. */
    public static final int BODY = 4;

    public static final int COLUMNS = 5;

    /** Place of the first sphere. */
    public static final int FIRST = Lanes.BORDER;

    public float[] values = {};

    /** Distance between columns. */
    public int stride;

    /** Distance between packets of spheres. */
    public int step;

    /** In blocks: the place of the body number of the sphere with that number along the blocks. */
    public static int bodyPlace(int sphere) {
        return FIRST + (sphere / Lanes.COUNT * COLUMNS + BODY) * Lanes.COUNT + sphere % Lanes.COUNT;
    }

    /**
     * Allocates room for that number of spheres, one complete column after the other. The content is lost if it grows.
     */
    public void reserveList(int most) {
        if (stride < most + Lanes.COUNT) {
            stride = most + Lanes.COUNT;
            step = Lanes.COUNT;
            values = new float[FIRST + COLUMNS * stride];
        }
    }

    /** Allocates room for that number of blocks of {@link Lanes#COUNT} spheres, and keeps the content. */
    public void reserveBlocks(int most) {
        stride = Lanes.COUNT;
        step = COLUMNS * Lanes.COUNT;
        if (values.length < FIRST + most * step) {
            values = Arrays.copyOf(values, FIRST + 2 * most * step);
        }
    }

    /**
     * Copies some spheres of a packet contiguously. The target needs room for a whole packet.
     *
     * @param to place of the first copy
     * @param from place of the source packet
     * @param lanes one bit per sphere to copy
     */
    public void copy(int to, SphereColumns others, int from, long lanes) {
        for (int column = 0; column < COLUMNS; column++) {
            Lanes.pack(others.values, from + column * others.stride, lanes, values, to + column * stride);
        }
    }
}
