package dev.twister.oracle;

import dev.twister.kernel.Noise;

/**
 * Random numbers of a pixel sample for lens and surfaces: Kronecker sequences of roots of primes, shifted by the
 * kernel's hash, whose integers are exact everywhere.
 *
 * @param column of the pixel in the whole picture
 * @param row of the pixel in the whole picture
 * @param item index in the infinite sequence of samples
 */
record SampleNumbers(int column, int row, int item) {
    private static final int[] PRIMES = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43};

    /** The hash counts a sample's two coordinates as its first two numbers. */
    private static final int FIRST = 2;

    private static final int SURFACES = 6;
    private static final double SHIFTS = 65536;

    double lensRadius() {
        return number(0);
    }

    double lensTurns() {
        return number(1);
    }

    double facetTurns(int bounce) {
        return number(2 + 2 * (bounce % SURFACES));
    }

    double facetHeight(int bounce) {
        return number(3 + 2 * (bounce % SURFACES));
    }

    private double number(int index) {
        double unshifted = Math.rint(0x1p24 * fraction(0.5 + item * Math.sqrt(PRIMES[index]))) / 0x1p24;
        return fraction(Math.min(unshifted, 1 - 0x1p-24) + Noise.hash(column, row, FIRST + index) / SHIFTS);
    }

    private static double fraction(double value) {
        return value - Math.floor(value);
    }
}
