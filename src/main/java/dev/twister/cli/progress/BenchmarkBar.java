package dev.twister.cli.progress;

import dev.twister.bench.benchmark.BenchmarkProgress;
import dev.twister.image.PictureSize;

/** Shows on a progress line what is measured, and how far that is. */
public final class BenchmarkBar implements BenchmarkProgress {
    private final ProgressLine line;
    private long next;
    private long drawn;

    public BenchmarkBar(ProgressLine line) {
        this.line = line;
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
}
