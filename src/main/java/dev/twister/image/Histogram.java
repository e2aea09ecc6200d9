package dev.twister.image;

/**
 * Number of pixels at each level of a displayed picture.
 *
 * @param red number of pixels by level, 0 to 255; green and blue likewise
 * @param luma number of pixels by Rec. 709's weighted mean of the levels
 * @param pixels number of counted pixels
 * @param white number of pixels with a channel at 255, which are clipped
 * @param black number of pixels with all channels at 0
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record Histogram(int[] red, int[] green, int[] blue, int[] luma, int pixels, int white, int black) {
    public static final int LEVELS = 256;
    private static final int MAX_LEVEL = LEVELS - 1;

    /** Rec. 709's weights in units of 1/65536. */
    private static final int RED = 13933;

    private static final int GREEN = 46871;
    private static final int BLUE = 4732;
    private static final int WEIGHT_BITS = 16;

    /**
     * Counts pixels (0xAARRGGBB, row by row), spread evenly over the picture.
     *
     * @param width pixels per row
     * @param most limit of the counted pixels, except for rounding
     */
    public static Histogram of(int[] argb, int width, int most) {
        int[] red = new int[LEVELS];
        int[] green = new int[LEVELS];
        int[] blue = new int[LEVELS];
        int[] luma = new int[LEVELS];
        int stride = stride(argb.length, width, most);
        int pixels = 0;
        int white = 0;
        int black = 0;
        for (int at = 0; at < argb.length; at += stride) {
            int pixel = argb[at];
            int r = pixel >> 16 & MAX_LEVEL;
            int g = pixel >> 8 & MAX_LEVEL;
            int b = pixel & MAX_LEVEL;
            red[r]++;
            green[g]++;
            blue[b]++;
            luma[(RED * r + GREEN * g + BLUE * b) >> WEIGHT_BITS]++;
            pixels++;
            white += isWhite(pixel) ? 1 : 0;
            black += isBlack(pixel) ? 1 : 0;
        }
        return new Histogram(red, green, blue, luma, pixels, white, black);
    }

    /** Whether a channel is at its highest level. */
    public static boolean isWhite(int argb) {
        return (argb >> 16 & MAX_LEVEL) == MAX_LEVEL
                || (argb >> 8 & MAX_LEVEL) == MAX_LEVEL
                || (argb & MAX_LEVEL) == MAX_LEVEL;
    }

    /** Whether all channels are at 0. */
    public static boolean isBlack(int argb) {
        return (argb & 0xFFFFFF) == 0;
    }

    /** In [0, 1]. */
    public double whiteShare() {
        return (double) white / pixels;
    }

    /** In [0, 1]. */
    public double blackShare() {
        return (double) black / pixels;
    }

    /** A step that meets every column; otherwise only some columns would be counted. */
    private static int stride(int length, int width, int most) {
        int stride = Math.max(1, Math.ceilDiv(length, most));
        while (greatestCommonDivisor(stride, width) > 1) {
            stride++;
        }
        return stride;
    }

    private static int greatestCommonDivisor(int a, int b) {
        return b == 0 ? a : greatestCommonDivisor(b, a % b);
    }
}
