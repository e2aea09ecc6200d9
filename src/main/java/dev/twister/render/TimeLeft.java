package dev.twister.render;

import java.time.Duration;

/** How long work still takes that goes on as it went up to now. */
public final class TimeLeft {
    private TimeLeft() {}

    /**
     * The time left.
     *
     * @param elapsedNanos since the work began
     * @param part of it that is done, in [0, 1]
     * @return 0 where nothing is done
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
