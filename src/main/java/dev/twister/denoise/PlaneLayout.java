package dev.twister.denoise;

import java.util.stream.IntStream;

/**
 * Planes of a picture with one float per pixel, row by row from the top. Each row has a border of pixels before and
 * after it, so that neighbors are read without a test of the column.
 */
record PlaneLayout(int width, int height) {
    /** Pixels in a border. */
    static final int BORDER = 32;

    private static final int CHANNELS = 3;

    /** Floats from a pixel to the one below. */
    int stride() {
        return width + 2 * BORDER;
    }

    /** Index of a row's first pixel. */
    int first(int y) {
        return y * stride() + BORDER;
    }

    /** A plane of zeros. */
    float[] plane() {
        return new float[Math.multiplyExact(stride(), height)];
    }

    /** Three planes with the finite values of an interleaved one, and 0 for the others. */
    float[][] planes(Plane interleaved) {
        float[][] planes = {plane(), plane(), plane()};
        rows().forEach(y -> {
            int from = interleaved.first() + CHANNELS * width * y;
            for (int x = 0; x < width; x++) {
                for (int channel = 0; channel < CHANNELS; channel++) {
                    float value = interleaved.values()[from + CHANNELS * x + channel];
                    planes[channel][first(y) + x] = Float.isFinite(value) ? value : 0;
                }
            }
        });
        return planes;
    }

    /** The numbers of the rows, for several threads. */
    IntStream rows() {
        return IntStream.range(0, height).parallel();
    }
}
