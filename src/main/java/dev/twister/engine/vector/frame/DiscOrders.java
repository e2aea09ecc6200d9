package dev.twister.engine.vector.frame;

import java.util.Arrays;

/**
 * The shadow samples of the unit disc, sorted along each of {@value #DIRECTIONS} directions. Along the direction across
 * a sphere's edge, the samples near the edge are contiguous. Reused while the samples are the same.
 */
public final class DiscOrders {
    /** With fewer samples than this, all are tested; see {@code docs/decisions/013}. */
    public static final int FEW = 48;

    /** Number of directions, evenly around the circle. */
    static final int DIRECTIONS = 32;

    /** Number of intervals of equal width along a direction. */
    private static final int STEPS = 64;

    /** Components of the directions along U and W. */
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

    /** Number of samples before each interval, followed by the total, direction by direction. */
    private int[] before = {};

    private float[] source = {};
    private int count;

    @SuppressWarnings("ReferenceEquality") // an input's arrays are immutable
    public void take(float[] disc, int newCount) {
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
        // Sort key: the position's bits, which compare like the float because it is not negative, above the sample's
        // number.
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

    /** The number of the direction nearest to (u, w). */
    public static int nearest(float u, float w) {
        float least = Math.min(Math.abs(u), Math.abs(w));
        float most = Math.max(Math.abs(u), Math.abs(w));
        float ratio = most > 0f ? least / most : 0f;
        // Approximate arc tangent in eighths of a turn; its error is at most 0.005.
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

    /** Index in {@link #samples}, in samples, of the first one along the direction. */
    public int first(int direction) {
        return direction * count;
    }

    /** A lower bound of the number of samples before a position along the direction. */
    public int before(int direction, float place) {
        return place <= -1f ? 0 : place >= 1f ? count : before[direction * (STEPS + 1) + step(place)];
    }

    /** An upper bound of the number of samples up to a position along the direction. */
    public int upTo(int direction, float place) {
        return place <= -1f ? 0 : place >= 1f ? count : before[direction * (STEPS + 1) + step(place) + 1];
    }
}
