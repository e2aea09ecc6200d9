package dev.twister.cli.progress;

import dev.twister.render.TimeLeft;
import java.io.PrintWriter;
import java.util.Locale;
import java.util.function.LongSupplier;

/**
 * How far work is, in the lines that Open Job Description reads: {@code openjd_progress} and {@code openjd_status}. At
 * most one pair a second, and one at the end.
 */
final class StatusLines {
    private static final long NANOS_BETWEEN = 1_000_000_000L;

    private final PrintWriter out;
    private final String task;
    private final long steps;
    private final LongSupplier nanoTime;
    private final long start;
    private long last;
    private long done;

    /**
     * Lines for work that begins now.
     *
     * @param steps 1 or more
     * @param nanoTime the clock
     */
    StatusLines(PrintWriter out, String task, long steps, LongSupplier nanoTime) {
        this.out = out;
        this.task = task;
        this.steps = steps;
        this.nanoTime = nanoTime;
        start = nanoTime.getAsLong();
        last = start;
    }

    void step() {
        stepTo(done + 1);
    }

    void stepTo(long step) {
        done = step;
        long now = nanoTime.getAsLong();
        if (now - last >= NANOS_BETWEEN || done == steps) {
            last = now;
            out.printf(Locale.ROOT, "openjd_progress: %.1f%n", 100.0 * done / steps);
            out.printf(
                    "openjd_status: %s: %d of %d, %s left%n",
                    task, done, steps, TimeLeft.text(TimeLeft.of(now - start, (double) done / steps)));
            out.flush();
        }
    }
}
