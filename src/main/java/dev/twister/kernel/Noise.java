package dev.twister.kernel;

/** Numbers in [0, 1) that look random, and are the same on every engine and in every run. */
public final class Noise {
    private static final int BITS = 0xffff;

    /** Shifts are multiples of it. */
    private static final float STEP = 0x1p-16f;

    private Noise() {}

    /**
     * A number of the path's sample, shifted by a hash of the pixel and the number's place, so that neighbors do not share
     * their noise.
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
    static int surface(int bounce) {
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

    /**
     * Another number of 16 bits for each, none twice. The factors stand for 0x88b5 and
     * 0xdb2d modulo 2^16; no product reaches 2^31, as an overflow is not defined on every device.
     */
    private static int mixed(int value) {
        int mixed = ((value ^ (value >> 8)) * -0x774b) & BITS;
        mixed = ((mixed ^ (mixed >> 7)) * -0x24d3) & BITS;
        return mixed ^ (mixed >> 9);
    }
}
