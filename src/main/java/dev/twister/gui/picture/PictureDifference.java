package dev.twister.gui.picture;

import java.util.Arrays;

/**
 * How two pictures differ.
 *
 * @param largest of all pixels' and channels' differences, of 255
 * @param x of the first pixel with the largest difference; 0 if none differs
 * @param y as x
 * @param differing pixels that are more than 1 of 255 apart in any channel
 * @param pixels of each picture
 */
public record PictureDifference(int largest, int x, int y, int differing, int pixels) {
    private static final int OPAQUE = 0xFF000000;

    /** So that a sixteenth of white is white. */
    private static final int MAGNIFIED = 16;

    /**
     * Compares pixels.
     *
     * @param width of both pictures
     * @throws IllegalArgumentException if the pictures differ in their number of pixels
     */
    public static PictureDifference of(int[] one, int[] other, int width) {
        if (one.length != other.length) {
            throw new IllegalArgumentException(one.length + " pixels compared with " + other.length);
        }
        int largest = 0;
        int place = 0;
        int differing = 0;
        for (int pixel = 0; pixel < one.length; pixel++) {
            int difference = largest(one[pixel], other[pixel]);
            if (difference > largest) {
                largest = difference;
                place = pixel;
            }
            differing += difference > 1 ? 1 : 0;
        }
        return new PictureDifference(largest, place % width, place / width, differing, one.length);
    }

    /** The difference of each channel, {@value #MAGNIFIED} times as bright, as 0xAARRGGBB. */
    public static int[] picture(int[] one, int[] other) {
        int[] argb = new int[one.length];
        Arrays.setAll(
                argb,
                pixel -> OPAQUE
                        | shown(one[pixel], other[pixel], 16) << 16
                        | shown(one[pixel], other[pixel], 8) << 8
                        | shown(one[pixel], other[pixel], 0));
        return argb;
    }

    private static int largest(int one, int other) {
        return Math.max(difference(one, other, 16), Math.max(difference(one, other, 8), difference(one, other, 0)));
    }

    private static int shown(int one, int other, int shift) {
        return Math.min(255, MAGNIFIED * difference(one, other, shift));
    }

    private static int difference(int one, int other, int shift) {
        return Math.abs((one >> shift & 255) - (other >> shift & 255));
    }
}
