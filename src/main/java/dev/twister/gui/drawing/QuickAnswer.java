package dev.twister.gui.drawing;

import java.util.concurrent.TimeUnit;

/** How much smaller a picture is with which a slow engine answers first. */
final class QuickAnswer {
    /** A picture that takes longer is preceded by a smaller one. */
    static final long LONG_NANOS = TimeUnit.MILLISECONDS.toNanos(150);

    /** How long the smaller one may take. */
    private static final long QUICK_NANOS = TimeUnit.MILLISECONDS.toNanos(60);

    static final int MOST = 8;

    private QuickAnswer() {}

    /**
     * What the sides of the first picture are divided by: 1 where the full one is quick enough, or nothing is known of
     * it.
     *
     * @param nanos that the full picture takes; 0 where it is not known
     */
    static int divisor(long nanos) {
        int divisor = 1;
        while (nanos > LONG_NANOS && divisor < MOST && nanos / divisor / divisor > QUICK_NANOS) {
            divisor *= 2;
        }
        return divisor;
    }
}
