package dev.twister.sky.image;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;

/**
 * The conversion of a decoded JPEG of four channels to RGB, by the amounts of ink alone, without a color profile.
 *
 * @param inverted whether 0 stands for all of an ink, as Adobe's programs write it
 * @param ycck whether the first three channels are luminance and chrominance instead of inks
 */
record CmykColors(boolean inverted, boolean ycck) {
    private static final int CHANNELS = 4;

    BufferedImage rgb(Raster inks) {
        int width = inks.getWidth();
        BufferedImage image = new BufferedImage(width, inks.getHeight(), BufferedImage.TYPE_INT_RGB);
        int[] row = new int[CHANNELS * width];
        int[] colors = new int[width];
        for (int y = 0; y < inks.getHeight(); y++) {
            inks.getPixels(inks.getMinX(), inks.getMinY() + y, width, 1, row);
            for (int x = 0; x < width; x++) {
                colors[x] = color(row, CHANNELS * x);
            }
            image.setRGB(0, y, width, 1, colors, 0, width);
        }
        return image;
    }

    private int color(int[] row, int at) {
        if (ycck) {
            separate(row, at);
        }
        int black = paper(row[at + 3]);
        int red = Math.round(paper(row[at]) * black / 255f);
        int green = Math.round(paper(row[at + 1]) * black / 255f);
        int blue = Math.round(paper(row[at + 2]) * black / 255f);
        return red << 16 | green << 8 | blue;
    }

    /** How much of the light an ink leaves, 0 to 255. */
    private int paper(int sample) {
        return inverted ? sample : 255 - sample;
    }

    /** Luminance and chrominance to cyan, magenta and yellow (ITU-T T.872). */
    private static void separate(int[] row, int at) {
        float luminance = row[at];
        float blueness = row[at + 1] - 128f;
        float redness = row[at + 2] - 128f;
        row[at] = 255 - clamped(luminance + 1.402f * redness);
        row[at + 1] = 255 - clamped(luminance - 0.344136f * blueness - 0.714136f * redness);
        row[at + 2] = 255 - clamped(luminance + 1.772f * blueness);
    }

    private static int clamped(float value) {
        return Math.clamp(Math.round(value), 0, 255);
    }
}
