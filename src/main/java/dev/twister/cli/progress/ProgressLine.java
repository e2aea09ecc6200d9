package dev.twister.cli.progress;

import java.io.PrintWriter;
import java.io.Writer;
import java.util.Optional;
import me.tongfei.progressbar.DelegatingProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/**
 * A progress bar on a terminal, gone without a trace when it is closed, or lines for a program that watches; nothing at
 * all elsewhere.
 */
public final class ProgressLine implements AutoCloseable {
    /**
     * Set by the launcher, which knows whether the error output is a terminal, and how many columns it has; Java does
     * not. 0 where it is none.
     */
    private static final String COLUMNS_PROPERTY = "twister.terminal.columns";

    /** Longer lines are hard to read. */
    private static final int MOST_COLUMNS = 100;

    private static final int UPDATE_MILLIS = 200;

    private final PrintWriter err;
    private final int columns;
    private final Optional<ProgressBar> bar;
    private final Optional<StatusLines> lines;

    private ProgressLine(PrintWriter err, int columns, Optional<ProgressBar> bar, Optional<StatusLines> lines) {
        this.err = err;
        this.columns = columns;
        this.bar = bar;
        this.lines = lines;
    }

    /** For a program that reads lines. */
    public static ProgressLine of(StatusLines lines) {
        return new ProgressLine(new PrintWriter(Writer.nullWriter()), 0, Optional.empty(), Optional.of(lines));
    }

    public static ProgressLine start(PrintWriter err, String task, long steps) {
        return start(err, task, steps, Integer.getInteger(COLUMNS_PROPERTY, 0));
    }

    /**
     * The same for a terminal of some width.
     *
     * @param terminal its columns; below 2 there is none
     */
    public static ProgressLine start(PrintWriter err, String task, long steps, int terminal) {
        // Terminals begin a new line after their last column.
        int columns = Math.min(MOST_COLUMNS, terminal - 1);
        return new ProgressLine(
                err,
                columns,
                columns > 0 ? Optional.of(bar(err, task, steps, columns)) : Optional.empty(),
                Optional.empty());
    }

    // Own consumer, own width: the library's would load a terminal library with native code to ask for them.
    private static ProgressBar bar(PrintWriter err, String task, long steps, int columns) {
        return new ProgressBarBuilder()
                .setTaskName(task)
                .setInitialMax(steps)
                .setStyle(ProgressBarStyle.ASCII)
                .setUpdateIntervalMillis(UPDATE_MILLIS)
                .setConsumer(new DelegatingProgressBarConsumer(text -> show(err, text), columns))
                .build();
    }

    private static void show(PrintWriter err, String text) {
        err.print("\r" + text);
        err.flush();
    }

    public void step() {
        bar.ifPresent(ProgressBar::step);
        lines.ifPresent(StatusLines::step);
    }

    void stepTo(long step) {
        bar.ifPresent(shown -> shown.stepTo(step));
        lines.ifPresent(shown -> shown.stepTo(step));
    }

    /** Shows what is being done, behind the bar. */
    void says(String what) {
        bar.ifPresent(shown -> shown.setExtraMessage(" " + what));
    }

    /** Removes the bar from the terminal until its next update, so that a line can be printed. */
    void clear() {
        if (bar.isPresent()) {
            show(err, " ".repeat(columns) + "\r");
        }
    }

    @Override
    public void close() {
        bar.ifPresent(ProgressBar::close);
        clear();
    }
}
