package dev.twister.oracle;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The difference of two pictures of one size, in 255ths of a channel.
 *
 * @param pixels number of pixels in each picture
 * @param differing indices of pixels with a channel difference above 1 of 255, in ascending order
 * @param largest the largest difference of a channel
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record PictureDifference(int pixels, int[] differing, int largest) {
    /** The design's bound: at most 1 pixel in this many may differ by more than 1 of 255 in a channel. */
    public static final int PIXELS_AN_ODD_ONE = 5000;

    /** Compares 0xAARRGGBB pixels. */
    public static PictureDifference between(int[] actual, int[] expected) {
        if (actual.length != expected.length) {
            throw new IllegalArgumentException(actual.length + " pixels and " + expected.length);
        }
        int[] differences = new int[actual.length];
        Arrays.setAll(differences, pixel -> channelDifference(actual[pixel], expected[pixel]));
        return new PictureDifference(
                actual.length,
                IntStream.range(0, differences.length)
                        .filter(pixel -> differences[pixel] > 1)
                        .toArray(),
                Arrays.stream(differences).max().orElse(0));
    }

    /** Returns whether the design's bound holds. */
    public boolean isWithinBound() {
        return (long) differing.length * PIXELS_AN_ODD_ONE <= pixels;
    }

    /** Returns the largest difference of the four channels. */
    static int channelDifference(int argb, int other) {
        int largest = 0;
        for (int shift = 0; shift < 32; shift += 8) {
            largest = Math.max(largest, Math.abs((argb >> shift & 0xFF) - (other >> shift & 0xFF)));
        }
        return largest;
    }

    @Override
    public String toString() {
        return differing.length + " of " + pixels + " pixels differ, by up to " + largest + " of 255, first "
                + Arrays.toString(Arrays.copyOf(differing, Math.min(differing.length, 8)));
    }
}
