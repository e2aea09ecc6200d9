package dev.twister.kernel;

/** Numbers in [0, 1) that look random, and are the same on every engine and in every run. */
public final class Noise {
    /**
     * Of what is mixed: the first bits, whose products stay below 2^31, as an overflow is not defined on every device.
     */
    public static final int BITS = 0xffff;

    /** 0x88b5 and 0xdb2d modulo 2^16. */
    public static final int FIRST_FACTOR = -0x774b;

    public static final int SECOND_FACTOR = -0x24d3;
    public static final int FIRST_SHIFT = 8;
    public static final int SECOND_SHIFT = 7;
    public static final int THIRD_SHIFT = 9;

    /** Shifts are multiples of it. */
    public static final float STEP = 0x1p-16f;

    private Noise() {}

    /**
     * A number of the path's sample, shifted by a hash of the pixel and the number's place, so that neighbors do not
     * share their noise.
     *
     * @param path with {@link Layout#PIXEL_COLUMN}, {@link Layout#PIXEL_ROW} and {@link Layout#PIXEL_SAMPLE}
     * @param pixelSamples {@link Layout#SAMPLE_STRIDE} floats a sample
     * @param place from {@link Layout#SAMPLE_LENS} to before {@link Layout#SAMPLE_STRIDE}
     */
    static float number(float[] path, float[] pixelSamples, int place) {
        float number = pixelSamples[(int) path[Layout.PIXEL_SAMPLE] + place]
                + STEP * hash((int) path[Layout.PIXEL_COLUMN], (int) path[Layout.PIXEL_ROW], place);
        return number >= 1f ? number - 1f : number;
    }

    /**
     * Where in a sample the pair of numbers for the surface is that a path meets after that many bounces.
     *
     * @param bounce 0 or more
     */
    public static int surface(int bounce) {
        return Layout.SAMPLE_SURFACE + 2 * (bounce - bounce / Layout.SAMPLE_SURFACES * Layout.SAMPLE_SURFACES);
    }

    /**
     * In [0, 65536), each value as often as any other. Two pixels that share one place's number do not share another's.
     *
     * @param column in [0, 65536), as row
     * @param place in [0, 32768)
     */
    public static int hash(int column, int row, int place) {
        return mixed(mixed(column ^ mixed(2 * place)) ^ mixed(row ^ mixed(2 * place + 1)));
    }

    /** Another number in [0, 65536) for each, none twice. */
    public static int mixed(int value) {
        int mixed = ((value ^ (value >> FIRST_SHIFT)) * FIRST_FACTOR) & BITS;
        mixed = ((mixed ^ (mixed >> SECOND_SHIFT)) * SECOND_FACTOR) & BITS;
        return mixed ^ (mixed >> THIRD_SHIFT);
    }
}
