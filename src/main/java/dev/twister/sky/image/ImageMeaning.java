package dev.twister.sky.image;

import java.util.Arrays;

/**
 * What an image file says of its samples besides the samples.
 *
 * @param colors how they become light
 * @param orientation of EXIF, 1 to 8; anything else counts as 1, upright
 * @param isPalette whether they are numbers of colors in a palette
 * @param transparent the samples of the one color that is transparent; empty where there is none
 */
@SuppressWarnings("ArrayRecordComponent") // read in place, for every texel
public record ImageMeaning(ColorEncoding colors, int orientation, boolean isPalette, int[] transparent) {
    /** Of an image without transparent texels or a palette. */
    static ImageMeaning opaque(ColorEncoding colors, int orientation) {
        return new ImageMeaning(colors, orientation, false, new int[0]);
    }

    /** In which order an image of that number of texels stores them. */
    ScanOrder order(int storedWidth, int storedHeight) {
        return ScanOrder.ofExif(orientation, storedWidth, storedHeight);
    }

    /** Whether texels of one color are transparent; there are no other opacities then. */
    boolean hasTransparentColor() {
        return transparent.length > 0;
    }

    /** Whether the texel whose samples begin at an index is of the transparent color. */
    boolean isTransparent(int[] samples, int index) {
        return Arrays.equals(samples, index, index + transparent.length, transparent, 0, transparent.length);
    }
}
