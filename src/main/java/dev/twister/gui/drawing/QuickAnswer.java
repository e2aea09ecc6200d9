package dev.twister.gui.drawing;

import java.util.concurrent.TimeUnit;

/** The size of the small picture that comes before a slow one. */
final class QuickAnswer {
    /** A picture that takes longer is preceded by a smaller one. */
    static final long LONG_NANOS = TimeUnit.MILLISECONDS.toNanos(150);

    /** The time that the smaller one may take. */
    private static final long QUICK_NANOS = TimeUnit.MILLISECONDS.toNanos(60);

    static final int MOST = 8;

    /** In path tracing. */
    static final int MOST_TRACED = 16;

    private QuickAnswer() {}

    /**
     * Divisor of the sides of the first picture: 1 if the full picture is fast enough or its time is unknown.
     *
     * @param nanos time of the full picture; 0 if unknown
     * @param most the largest divisor
     */
    static int divisor(long nanos, int most) {
        int divisor = 1;
        while (nanos > LONG_NANOS && divisor < most && nanos / divisor / divisor > QUICK_NANOS) {
            divisor *= 2;
        }
        return divisor;
    }
}
