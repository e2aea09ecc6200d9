package dev.twister.cli;

import dev.twister.bench.BenchmarkProgress;
import dev.twister.bench.PaperPlan;
import dev.twister.bench.PictureSize;
import java.io.PrintWriter;

/** One progress bar for the whole evaluation, with the time left. */
final class PaperLine implements BenchmarkProgress, AutoCloseable {
    private final ProgressLine line;
    private long next;
    private long drawn;

    PaperLine(PrintWriter err, PaperPlan plan) {
        long settings = plan.settings().size();
        line = ProgressLine.start(
                err, "evaluation", settings + settings * plan.engines().size() * plan.framesEach());
    }

    /** An engine whose time was up early has drawn fewer frames than foreseen: the bar jumps over the rest. */
    @Override
    public void begins(String engine, PictureSize size, int frames) {
        drawn = next;
        next += frames;
        line.stepTo(drawn);
        line.says(engine + " " + size);
    }

    @Override
    public void drewFrame() {
        drawn++;
        line.stepTo(drawn);
    }

    @Override
    public void close() {
        line.close();
    }
}
