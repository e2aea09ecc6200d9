package dev.twister.sky;

/**
 * An image of 8 bits per channel.
 *
 * @param texels row by row from the top: red in the lowest bits, then green, blue and opacity, 0 to 255 each
 * @param linear what the 256 values of a color channel stand for, 0 to 1
 */
@SuppressWarnings("ArrayRecordComponent") // read in place; comparing images is no one's need
public record PackedImage(int width, int height, int[] texels, float[] linear, boolean isOpaque)
        implements TextureImage {
    public static final int VALUES = 256;

    /** A channel's value: 0 red, 1 green, 2 blue, 3 opacity. */
    public int value(int texel, int channel) {
        return texels[texel] >> 8 * channel & VALUES - 1;
    }
}
