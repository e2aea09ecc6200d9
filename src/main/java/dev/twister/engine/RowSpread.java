package dev.twister.engine;

/**
 * An order of a picture's rows of which every part has rows from everywhere. A parallel stream cuts its range into few
 * parts, each for one thread; with rows in order a part of sky would be done long before one of spheres, and its thread
 * idle.
 *
 * @param height of the picture, at least 1
 * @param step from one row to the next, around the picture's end; has no divisor in common with the height
 */
record RowSpread(int height, int step) {
    /** The part of a circle after which places lie most evenly, however many there are. */
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

    /** The row at this place of the order. */
    int row(int index) {
        return (int) ((long) index * step % height);
    }
}
