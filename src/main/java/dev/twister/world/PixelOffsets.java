package dev.twister.world;

/** The samples' places in a pixel: Roberts's R2 sequence (2018), even for any number of samples. */
final class PixelOffsets {
    /** The plastic number, the real root of x^3 = x + 1. */
    private static final double PLASTIC = 1.324717957244746;

    private PixelOffsets() {}

    /** {@code 2 * count} floats in [0, 1): x and y of each sample. A single sample is the pixel's corner. */
    static float[] places(int count) {
        return count == 1 ? new float[2] : places(0, count);
    }

    /** As many of the sequence's places, from that one on: runs that follow each other are those of one long run. */
    static float[] places(int first, int count) {
        float[] places = new float[2 * count];
        for (int i = 0; i < count; i++) {
            places[2 * i] = fraction(0.5 + (first + i) / PLASTIC);
            places[2 * i + 1] = fraction(0.5 + (first + i) / (PLASTIC * PLASTIC));
        }
        return places;
    }

    private static float fraction(double value) {
        return Math.min((float) (value - Math.floor(value)), Math.nextDown(1f));
    }
}
