package dev.twister.kernel;

/** Pseudorandom numbers in [0, 1) that are the same on every engine and in every run. */
public final class Noise {
    /** Mask of the hashed bits. Their products stay below 2^31, because overflow is not defined on every device. */
    public static final int BITS = 0xffff;

    /** Congruent to 0x88b5 and 0xdb2d modulo 2^16. */
    public static final int FIRST_FACTOR = -0x774b;

    public static final int SECOND_FACTOR = -0x24d3;
    public static final int FIRST_SHIFT = 8;
    public static final int SECOND_SHIFT = 7;
    public static final int THIRD_SHIFT = 9;

    /** All shifts are multiples of it. */
    public static final float STEP = 0x1p-16f;

    private Noise() {}

    /**
     * One of the path sample's numbers, shifted by a hash of pixel and place, so that neighboring pixels have
     * independent noise.
     *
     * @param path with {@link Layout#PIXEL_COLUMN}, {@link Layout#PIXEL_ROW} and {@link Layout#PIXEL_SAMPLE}
     * @param place from {@link Layout#SAMPLE_LENS} to before {@link Layout#SAMPLE_STRIDE}
     */
    static float number(float[] path, int place, float[] frame) {
        float number = frame[(int) path[Layout.PIXEL_SAMPLE] + place]
                + STEP * hash((int) path[Layout.PIXEL_COLUMN], (int) path[Layout.PIXEL_ROW], place);
        return number >= 1f ? number - 1f : number;
    }

    /**
     * Place in a sample of the pair of numbers for the surface hit after that many bounces.
     *
     * @param bounce at least 0
     */
    public static int surface(int bounce) {
        return Layout.SAMPLE_SURFACE + 2 * (bounce - bounce / Layout.SAMPLE_SURFACES * Layout.SAMPLE_SURFACES);
    }

    /**
     * A hash in [0, 65536), uniformly distributed. Two pixels with equal hashes at one place differ at another.
     *
     * @param column in [0, 65536), like the row
     * @param place in [0, 32768)
     */
    public static int hash(int column, int row, int place) {
        return mixed(mixed(column ^ mixed(2 * place)) ^ mixed(row ^ mixed(2 * place + 1)));
    }

    /** A permutation of [0, 65536). */
    public static int mixed(int value) {
        int mixed = ((value ^ (value >> FIRST_SHIFT)) * FIRST_FACTOR) & BITS;
        mixed = ((mixed ^ (mixed >> SECOND_SHIFT)) * SECOND_FACTOR) & BITS;
        return mixed ^ (mixed >> THIRD_SHIFT);
    }
}
