package dev.twister.cli;

import dev.twister.bench.BenchmarkProgress;
import dev.twister.bench.PaperPlan;
import dev.twister.image.PictureSize;
import java.io.PrintWriter;
import java.util.function.Supplier;

/**
 * One progress bar for the whole evaluation, with the time left. Where the process ends before that, it says where that
 * was, and what is left.
 */
final class PaperLine implements BenchmarkProgress, AutoCloseable {
    private final PrintWriter err;
    private final Supplier<String> left;
    private final ProgressLine line;
    private final Unfinished unfinished = Unfinished.until(this::giveUp);
    private volatile String task = "its start";
    private long next;
    private long drawn;

    /** With what is asked, where the process ends before the evaluation, for what is left of it. */
    PaperLine(PrintWriter err, PaperPlan plan, Supplier<String> left) {
        this.err = err;
        this.left = left;
        long settings = plan.settings().size();
        long engines = plan.engines().size();
        line = ProgressLine.start(err, "evaluation", settings + engines * (1 + settings * plan.framesEach()));
    }

    /** An engine whose time was up early has drawn fewer frames than foreseen: the bar jumps over the rest. */
    @Override
    public void begins(String engine, PictureSize size, int frames) {
        drawn = next;
        next += frames;
        line.stepTo(drawn);
        task = engine + " " + size;
        line.says(task);
    }

    @Override
    public void drewFrame() {
        drawn++;
        line.stepTo(drawn);
    }

    private void giveUp() {
        line.close();
        err.println("twister: ended at " + task + ", before the evaluation was done; " + left.get());
        err.flush();
    }

    @Override
    public void close() {
        unfinished.close();
        line.close();
    }
}
