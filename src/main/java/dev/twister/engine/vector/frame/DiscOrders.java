package dev.twister.engine.vector.frame;

import java.util.Arrays;

/**
 * The shadow samples of the unit disc, in the order along each of {@value #DIRECTIONS} directions: what a sphere's edge
 * leaves in doubt lies close together along the direction across the edge. Kept while the samples are the same.
 */
public final class DiscOrders {
    /** With fewer samples all are looked at: {@code docs/decisions/013}. */
    public static final int FEW = 48;

    /** Evenly about the whole circle. */
    static final int DIRECTIONS = 32;

    /** Parts of equal width that the disc has along a direction. */
    private static final int STEPS = 64;

    /** The directions' parts along U and W. */
    private static final float[] ALONG_U = new float[DIRECTIONS];

    private static final float[] ALONG_W = new float[DIRECTIONS];

    static {
        for (int direction = 0; direction < DIRECTIONS; direction++) {
            double angle = 2 * Math.PI * direction / DIRECTIONS;
            ALONG_U[direction] = (float) Math.cos(angle);
            ALONG_W[direction] = (float) Math.sin(angle);
        }
    }

    /** x and y of the samples, direction by direction. */
    public float[] samples = {};

    /** How many samples lie before each step, and all of them, direction by direction. */
    private int[] before = {};

    private float[] source = {};
    private int count;

    @SuppressWarnings("ReferenceEquality") // an input's arrays never change
    void take(float[] disc, int newCount) {
        if (source != disc || count != newCount) {
            source = disc;
            count = newCount;
            samples = new float[DIRECTIONS * 2 * count];
            before = new int[DIRECTIONS * (STEPS + 1)];
            for (int direction = 0; direction < DIRECTIONS; direction++) {
                order(direction);
            }
        }
    }

    private void order(int direction) {
        // A sample's number below the bits of where it lies, which are in the order of floats, as none is below 0.
        long[] order = new long[count];
        for (int sample = 0; sample < count; sample++) {
            long place = Float.floatToRawIntBits(1f + Math.max(-1f, along(direction, sample)));
            order[sample] = place << Integer.SIZE | sample;
        }
        Arrays.sort(order);
        int at = direction * 2 * count;
        int first = direction * (STEPS + 1);
        Arrays.fill(before, first, first + STEPS + 1, 0);
        for (int k = 0; k < count; k++) {
            int sample = (int) order[k];
            samples[at + 2 * k] = source[2 * sample];
            samples[at + 2 * k + 1] = source[2 * sample + 1];
            before[first + 1 + step(along(direction, sample))]++;
        }
        for (int step = 1; step <= STEPS; step++) {
            before[first + step] += before[first + step - 1];
        }
    }

    private float along(int direction, int sample) {
        return source[2 * sample] * ALONG_U[direction] + source[2 * sample + 1] * ALONG_W[direction];
    }

    private static int step(float along) {
        return Math.clamp((int) ((along + 1f) * (STEPS / 2)), 0, STEPS - 1);
    }

    /** The number of the direction nearest to that one. */
    public static int nearest(float u, float w) {
        float least = Math.min(Math.abs(u), Math.abs(w));
        float most = Math.max(Math.abs(u), Math.abs(w));
        float ratio = most > 0f ? least / most : 0f;
        // An arc tangent in eighths of a circle, at most a two-hundredth of one wrong.
        float eighths = ratio * (1.3476f - 0.3476f * ratio);
        float quarter = Math.abs(w) > Math.abs(u) ? 2f - eighths : eighths;
        float half = u < 0f ? 4f - quarter : quarter;
        float angle = w < 0f ? 8f - half : half;
        return (int) (angle * (DIRECTIONS / 8) + 0.5f) % DIRECTIONS;
    }

    public static float alongU(int direction) {
        return ALONG_U[direction];
    }

    public static float alongW(int direction) {
        return ALONG_W[direction];
    }

    /** The number, in {@link #samples}, of the first sample along the direction. */
    public int first(int direction) {
        return direction * count;
    }

    /** How many samples, or some fewer, lie before the place along the direction. */
    public int before(int direction, float place) {
        return place <= -1f ? 0 : place >= 1f ? count : before[direction * (STEPS + 1) + step(place)];
    }

    /** How many samples, or some more, lie up to the place along the direction. */
    public int upTo(int direction, float place) {
        return place <= -1f ? 0 : place >= 1f ? count : before[direction * (STEPS + 1) + step(place) + 1];
    }
}
