package dev.twister.world;

/**
 * The samples' places in a pixel: item 0 is the center; items 2k - 1 and 2k are point k of Roberts's R2 sequence (2018) and
 * its mirror image through the center.
 */
final class PixelOffsets {
    /** The plastic number, the real root of x^3 = x + 1. */
    private static final double PLASTIC = 1.324717957244746;

    /** Places are whole multiples of it, so that floats hold a point and its mirror image without rounding. */
    private static final double STEP = 0x1p-24;

    private PixelOffsets() {}

    /**
     * {@code 2 * count} floats in (0, 1): x and y of each sample. Their mean is the pixel's center: an even number are whole
     * pairs, an odd number the center besides.
     */
    static float[] places(int count) {
        return places(count % 2 == 0 ? 1 : 0, count);
    }

    /** As many of the items, from that one on: runs that follow each other are those of one long run. */
    static float[] places(int first, int count) {
        float[] places = new float[2 * count];
        for (int i = 0; i < count; i++) {
            places[2 * i] = place(first + i, PLASTIC);
            places[2 * i + 1] = place(first + i, PLASTIC * PLASTIC);
        }
        return places;
    }

    private static float place(int item, double divisor) {
        int point = (item + 1) / 2;
        double value = 0.5 + point / divisor;
        double place = Math.clamp(STEP * Math.rint((value - Math.floor(value)) / STEP), STEP, 1 - STEP);
        return (float) (item % 2 == 0 ? 1 - place : place);
    }
}
