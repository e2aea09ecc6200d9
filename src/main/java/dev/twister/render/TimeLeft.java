package dev.twister.render;

import java.time.Duration;

/** Estimates the remaining time of work from its progress. */
public final class TimeLeft {
    private TimeLeft() {}

    /**
     * The remaining time, if the work continues at the same rate.
     *
     * @param elapsedNanos time since the start
     * @param part finished part, in [0, 1]
     * @return 0 if nothing is finished
     */
    public static Duration of(long elapsedNanos, double part) {
        return part <= 0 ? Duration.ZERO : Duration.ofNanos((long) (elapsedNanos / part * (1 - part)));
    }

    /** Such as {@code 34 s}, {@code 2 min 5 s} or {@code 3 h 12 min}. */
    public static String text(Duration left) {
        return left.toHours() > 0
                ? "%d h %d min".formatted(left.toHours(), left.toMinutesPart())
                : left.toMinutes() > 0
                        ? "%d min %d s".formatted(left.toMinutes(), left.toSecondsPart())
                        : left.toSeconds() + " s";
    }
}
