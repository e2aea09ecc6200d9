package dev.twister.oracle;

import dev.twister.kernel.Noise;

/**
 * Random numbers of a pixel sample for lens and surfaces: Kronecker sequences of roots of primes, shifted by the
 * kernel's hash, whose integers are exact everywhere; for later bounces the hash alone.
 *
 * @param column of the pixel in the whole picture
 * @param row of the pixel in the whole picture
 * @param item index in the infinite sequence of samples
 */
record SampleNumbers(int column, int row, int item) {
    private static final int[] PRIMES = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43};

    /** The hash counts a sample's two coordinates as its first two numbers. */
    private static final int FIRST = 2;

    private static final double SHIFTS = 65536;

    double lensRadius() {
        return number(0);
    }

    double lensTurns() {
        return number(1);
    }

    double facetTurns(int bounce) {
        return number(2 + 2 * bounce);
    }

    double facetHeight(int bounce) {
        return number(3 + 2 * bounce);
    }

    private double number(int index) {
        if (index >= PRIMES.length) {
            return hashed(FIRST + index);
        }
        double unshifted = Math.rint(0x1p24 * fraction(0.5 + item * Math.sqrt(PRIMES[index]))) / 0x1p24;
        return fraction(Math.min(unshifted, 1 - 0x1p-24) + Noise.hash(column, row, FIRST + index) / SHIFTS);
    }

    /** The numbers for bounces that have no sequence: 24 bits of hashes. */
    private double hashed(int place) {
        int sample = Noise.mixed(Noise.hash(column, row, place) ^ (item & 0xffff));
        int high = Noise.mixed(sample ^ Noise.mixed((item >> 16) ^ Noise.mixed(place)));
        int low = Noise.mixed(high ^ Noise.hash(row, column, place + 1)) & 255;
        return (high + low / 256.0) / SHIFTS;
    }

    private static double fraction(double value) {
        return value - Math.floor(value);
    }
}
