package dev.twister.cli;

import dev.twister.bench.BenchmarkProgress;
import dev.twister.bench.BenchmarkReport;
import dev.twister.bench.EngineFailure;
import dev.twister.bench.Measurement;
import dev.twister.bench.ReportTable;
import dev.twister.image.PictureSize;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiFunction;

/**
 * A progress bar for each engine and size in turn. Where the process ends before all are measured, it says where that was,
 * and what was measured until then, and writes it to files where a report was asked for.
 */
final class BenchmarkLines implements BenchmarkProgress, AutoCloseable {
    private final PrintWriter out;
    private final PrintWriter err;
    private final ReportFiles files;
    private final BiFunction<List<Measurement>, List<EngineFailure>, BenchmarkReport> report;
    private final List<Measurement> measurements = new CopyOnWriteArrayList<>();
    private final List<EngineFailure> failures = new CopyOnWriteArrayList<>();
    private final Unfinished unfinished = Unfinished.until(this::giveUp);
    private volatile String engine = "benchmark";
    private volatile String task = engine;
    private volatile ProgressLine line;

    /** With what makes a report of the measurements, and of what failed, that there are. */
    BenchmarkLines(
            PrintWriter out,
            PrintWriter err,
            ReportFiles files,
            BiFunction<List<Measurement>, List<EngineFailure>, BenchmarkReport> report) {
        this.out = out;
        this.err = err;
        this.files = files;
        this.report = report;
        line = ProgressLine.start(err, task, 1);
    }

    @Override
    public void begins(String engine, PictureSize size, int frames) {
        this.engine = engine;
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

    @Override
    public void failed(EngineFailure failure) {
        failures.add(failure);
    }

    /** What is left to say where the benchmark ends before its time. */
    void giveUp() {
        line.close();
        String ended = "ended at " + task + ", before the benchmark was done";
        if (measurements.isEmpty()) {
            err.println("twister: " + ended + "; nothing was measured");
        } else {
            failures.add(new EngineFailure(engine, ended));
            BenchmarkReport partial = report.apply(measurements, failures);
            err.println("twister: " + ended + "; " + files.writeUnfinished(partial));
            out.println(ReportTable.of(partial));
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
