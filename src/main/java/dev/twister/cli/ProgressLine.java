package dev.twister.cli;

import java.io.PrintWriter;
import java.util.Optional;
import me.tongfei.progressbar.DelegatingProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/** A progress bar on a terminal; nothing at all elsewhere. Gone without a trace when it is closed. */
final class ProgressLine implements AutoCloseable {
    /** Set by the launcher, which knows whether the error output is a terminal; Java does not. */
    private static final String TERMINAL_PROPERTY = "twister.terminal";

    private static final int COLUMNS = 79;
    private static final int UPDATE_MILLIS = 200;

    private final PrintWriter err;
    private final Optional<ProgressBar> bar;

    private ProgressLine(PrintWriter err, Optional<ProgressBar> bar) {
        this.err = err;
        this.bar = bar;
    }

    static ProgressLine start(PrintWriter err, String task, long steps) {
        return new ProgressLine(err, onTerminal() ? Optional.of(bar(err, task, steps)) : Optional.empty());
    }

    // Own consumer, own width: the library's would load a terminal library with native code to ask for them.
    private static ProgressBar bar(PrintWriter err, String task, long steps) {
        return new ProgressBarBuilder()
                .setTaskName(task)
                .setInitialMax(steps)
                .setStyle(ProgressBarStyle.ASCII)
                .setUpdateIntervalMillis(UPDATE_MILLIS)
                .setConsumer(new DelegatingProgressBarConsumer(text -> show(err, text), COLUMNS))
                .build();
    }

    private static void show(PrintWriter err, String text) {
        err.print("\r" + text);
        err.flush();
    }

    private static boolean onTerminal() {
        return Boolean.getBoolean(TERMINAL_PROPERTY);
    }

    void step() {
        bar.ifPresent(ProgressBar::step);
    }

    void stepTo(long step) {
        bar.ifPresent(shown -> shown.stepTo(step));
    }

    /** Shows what is being done, behind the bar. */
    void says(String what) {
        bar.ifPresent(shown -> shown.setExtraMessage(" " + what));
    }

    @Override
    public void close() {
        bar.ifPresent(shown -> {
            shown.close();
            show(err, " ".repeat(COLUMNS) + "\r");
        });
    }
}
