package dev.twister.cli;

import dev.twister.bench.BenchmarkProgress;
import dev.twister.bench.BenchmarkReport;
import dev.twister.bench.Measurement;
import dev.twister.bench.PictureSize;
import dev.twister.bench.ReportTable;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;

/**
 * A progress bar for each engine and size in turn. Where the process ends before all are measured, it says where that was,
 * and what was measured until then.
 */
final class BenchmarkLines implements BenchmarkProgress, AutoCloseable {
    private final PrintWriter out;
    private final PrintWriter err;
    private final Function<List<Measurement>, BenchmarkReport> report;
    private final List<Measurement> measurements = new CopyOnWriteArrayList<>();
    private final Unfinished unfinished = Unfinished.until(this::giveUp);
    private volatile String task = "benchmark";
    private volatile ProgressLine line;

    /** With what makes a report of the measurements that there are. */
    BenchmarkLines(PrintWriter out, PrintWriter err, Function<List<Measurement>, BenchmarkReport> report) {
        this.out = out;
        this.err = err;
        this.report = report;
        line = ProgressLine.start(err, task, 1);
    }

    @Override
    public void begins(String engine, PictureSize size, int frames) {
        task = engine + " " + size;
        line.close();
        line = ProgressLine.start(err, task, frames);
    }

    @Override
    public void drewFrame() {
        line.step();
    }

    @Override
    public void measured(Measurement measurement) {
        measurements.add(measurement);
    }

    /** What is left to say where the benchmark ends before its time. */
    void giveUp() {
        line.close();
        err.println("twister: ended at " + task + ", before the benchmark was done; "
                + (measurements.isEmpty() ? "nothing was measured" : "no file was written, but this was measured:"));
        if (!measurements.isEmpty()) {
            out.println(ReportTable.of(report.apply(measurements)));
        }
        err.flush();
        out.flush();
    }

    @Override
    public void close() {
        unfinished.close();
        line.close();
    }
}
