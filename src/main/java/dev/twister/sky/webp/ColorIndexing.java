package dev.twister.sky.webp;

import java.util.Arrays;

/**
 * A palette, whose indices are packed in green where they are few.
 *
 * @param colors as differences, each from the one before
 */
@SuppressWarnings("ArrayRecordComponent") // read in place
record ColorIndexing(int[] colors, int width, int height) implements LosslessTransform {
    /** Indices per packed texel, as a power of two. */
    private int packing() {
        if (colors.length > 16) {
            return 0;
        }
        if (colors.length > 4) {
            return 1;
        }
        return colors.length > 2 ? 2 : 3;
    }

    int packedWidth() {
        return LosslessTransform.blocks(width, packing());
    }

    @Override
    public int[] inverse(int[] argb) {
        int packing = packing();
        int bits = Byte.SIZE >> packing;
        // An index beyond the palette is clear black.
        int[] palette = Arrays.copyOf(colors, 1 << bits);
        for (int i = 1; i < colors.length; i++) {
            palette[i] = LosslessTransform.sum(palette[i], palette[i - 1]);
        }
        int packedWidth = packedWidth();
        int[] unpacked = packing == 0 ? argb : new int[width * height];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int packed = argb[row * packedWidth + (column >> packing)] >> 8;
                int place = column & (1 << packing) - 1;
                unpacked[row * width + column] = palette[packed >> (place * bits) & palette.length - 1];
            }
        }
        return unpacked;
    }
}
