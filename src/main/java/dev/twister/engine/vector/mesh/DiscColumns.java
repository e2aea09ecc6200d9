package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import java.util.Arrays;

/** A triangle seen from a packet's points on the light's disc, in columns of {@link Lanes#COUNT} floats. */
final class DiscColumns {
    /** The axes A, U and W in the coordinates of a mesh. */
    static final int ROW_A = Lanes.BORDER;

    static final int ROW_U = ROW_A + 3 * Lanes.COUNT;
    static final int ROW_W = ROW_A + 6 * Lanes.COUNT;

    /** The triangle's corners along A, U and W, relative to the points. */
    static final int A = ROW_A + 9 * Lanes.COUNT;

    static final int U = ROW_A + 12 * Lanes.COUNT;
    static final int W = ROW_A + 15 * Lanes.COUNT;

    /** The places on the plane at distance 1 that the edge functions count from. */
    static final int MIDDLE_U = ROW_A + 18 * Lanes.COUNT;

    static final int MIDDLE_W = ROW_A + 19 * Lanes.COUNT;

    /** The edge functions {@code x X + y Y + constant}, and the growth of the constants. */
    static final int X = ROW_A + 20 * Lanes.COUNT;

    static final int Y = ROW_A + 23 * Lanes.COUNT;
    static final int CONSTANT = ROW_A + 26 * Lanes.COUNT;
    static final int GROWTH = ROW_A + 29 * Lanes.COUNT;

    /** The volume between point and triangle; in the end what the sum of the edge functions exceeds before the disc. */
    static final int VOLUME = ROW_A + 32 * Lanes.COUNT;

    /** Distance between point and disc. */
    static final int DISTANCE = ROW_A + 33 * Lanes.COUNT;

    private static final int LENGTH = ROW_A + 34 * Lanes.COUNT;

    final float[] values = new float[LENGTH];

    /** The triangle's number in its mesh. */
    int number;

    /** For each sample from {@link Lanes#BORDER} on: 1 in lanes whose sample the current body hides, else 0. */
    float[] hits = {};

    /** For each sample: what the bodies so far transmit. */
    float[] light = {};

    /** Allocates room for some samples, and lights them all. */
    void start(int samples) {
        int length = Lanes.BORDER + samples * Lanes.COUNT;
        if (light.length < length) {
            light = new float[length];
            hits = new float[length];
        }
        Arrays.fill(light, Lanes.BORDER, length, 1f);
    }
}
