package dev.twister.world;

import dev.twister.kernel.Layout;

/**
 * The samples of a pixel. Positions: item 0 is the center; items 2k - 1 and 2k are point k of Roberts's R2 sequence
 * (2018) and its mirror image through the center. The numbers for lens and surfaces are Kronecker sequences of square
 * roots of different primes, which makes them independent.
 */
final class PixelSamples {
    /** The plastic number, the real root of x^3 = x + 1. */
    private static final double PLASTIC = 1.324717957244746;

    /** Positions are integer multiples of it, so that floats hold a point and its mirror image exactly. */
    private static final double STEP = 0x1p-24;

    private static final int[] PRIMES = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43};

    private PixelSamples() {}

    /**
     * {@code SAMPLE_STRIDE * count} floats, see {@link Layout}. The mean of the positions is the pixel's center: an
     * even count consists of mirrored pairs, an odd count also has the center.
     */
    static float[] of(int count) {
        return of(first(count), count);
    }

    /** The first item of {@link #of(int)}. */
    static int first(int count) {
        return count % 2 == 0 ? 1 : 0;
    }

    /** The items from {@code first} on; adjacent runs equal one long run. */
    static float[] of(int first, int count) {
        float[] samples = new float[Layout.SAMPLE_STRIDE * count];
        for (int i = 0; i < count; i++) {
            int at = Layout.SAMPLE_STRIDE * i;
            samples[at] = place(first + i, PLASTIC);
            samples[at + 1] = place(first + i, PLASTIC * PLASTIC);
            for (int number = 0; number < PRIMES.length; number++) {
                samples[at + Layout.SAMPLE_LENS + number] = fraction(0.5 + (first + i) * Math.sqrt(PRIMES[number]));
            }
        }
        return samples;
    }

    private static float place(int item, double divisor) {
        int point = (item + 1) / 2;
        double place = Math.max(fraction(0.5 + point / divisor), STEP);
        return (float) (item % 2 == 0 ? 1 - place : place);
    }

    /** The fractional part, rounded to a multiple of {@link #STEP} in [0, 1). */
    private static float fraction(double value) {
        return (float) Math.min(STEP * Math.rint((value - Math.floor(value)) / STEP), 1 - STEP);
    }
}
