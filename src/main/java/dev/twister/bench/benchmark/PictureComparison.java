package dev.twister.bench.benchmark;

/**
 * Comparison of an engine's picture with the reference.
 *
 * @param pixels number of pixels that were compared
 * @param differingPixels number of pixels that differ by more than {@value #CHANNEL_TOLERANCE} of 255 in any channel
 * @param largestDifference largest difference of any channel, of 255
 */
public record PictureComparison(int pixels, int differingPixels, int largestDifference) {
    /** Rounding changes a channel by at most one step. */
    public static final int CHANNEL_TOLERANCE = 1;

    /** One in this number of pixels may differ by more, where rounding moves an edge. */
    public static final int PIXELS_PER_DIFFERENCE = 5000;

    /**
     * Compares two pictures pixel by pixel.
     *
     * @throws IllegalArgumentException if the numbers of pixels differ
     */
    public static PictureComparison of(int[] reference, int[] argb) {
        if (reference.length != argb.length) {
            throw new IllegalArgumentException(argb.length + " pixels compared with " + reference.length);
        }
        int differing = 0;
        int largest = 0;
        for (int i = 0; i < argb.length; i++) {
            int difference = difference(reference[i], argb[i]);
            largest = Math.max(largest, difference);
            if (difference > CHANNEL_TOLERANCE) {
                differing++;
            }
        }
        return new PictureComparison(argb.length, differing, largest);
    }

    private static int difference(int one, int other) {
        int largest = 0;
        for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
            largest = Math.max(largest, Math.abs((one >> shift & 0xff) - (other >> shift & 0xff)));
        }
        return largest;
    }

    public int allowedPixels() {
        return pixels / PIXELS_PER_DIFFERENCE;
    }

    public boolean withinTolerance() {
        return differingPixels <= allowedPixels();
    }
}
