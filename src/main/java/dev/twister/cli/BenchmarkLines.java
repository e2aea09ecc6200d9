package dev.twister.cli;

import dev.twister.bench.BenchmarkProgress;
import dev.twister.bench.PictureSize;
import java.io.PrintWriter;

/** A progress bar for each engine and size in turn. */
final class BenchmarkLines implements BenchmarkProgress, AutoCloseable {
    private final PrintWriter err;
    private ProgressLine line;

    BenchmarkLines(PrintWriter err) {
        this.err = err;
        line = ProgressLine.start(err, "benchmark", 1);
    }

    @Override
    public void begins(String engine, PictureSize size, int frames) {
        line.close();
        line = ProgressLine.start(err, engine + " " + size, frames);
    }

    @Override
    public void drewFrame() {
        line.step();
    }

    @Override
    public void close() {
        line.close();
    }
}
