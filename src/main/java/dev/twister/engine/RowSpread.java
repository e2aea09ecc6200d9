package dev.twister.engine;

/**
 * An order of a picture's rows that spreads every part of it over the whole picture. A parallel stream splits its range
 * into few parts, one per thread. With consecutive rows, a part of sky would finish long before one of spheres and
 * leave its thread idle.
 *
 * @param height the picture's height, at least 1
 * @param step distance between successive rows, modulo the height; coprime to it
 */
record RowSpread(int height, int step) {
    /** Steps of this part of a circle spread any number of points evenly. */
    private static final double GOLDEN_SECTION = 0.6180339887498949;

    RowSpread(int height) {
        this(height, coprime(height, (int) (height * GOLDEN_SECTION)));
    }

    private static int coprime(int height, int from) {
        int step = Math.max(1, from);
        while (divisor(height, step) != 1) {
            step++;
        }
        return step;
    }

    private static int divisor(int a, int b) {
        return b == 0 ? a : divisor(b, a % b);
    }

    /** The row at an index of the order. */
    int row(int index) {
        return (int) ((long) index * step % height);
    }
}
