package dev.twister.cli.progress;

import dev.twister.bench.ReportNumbers;
import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.BenchmarkProgress;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.EngineFailure;
import dev.twister.bench.benchmark.Setting;
import dev.twister.bench.report.ReportTable;
import dev.twister.cli.file.ReportFiles;
import dev.twister.files.LastWrites;
import dev.twister.image.PictureSize;
import java.io.PrintWriter;
import java.util.Locale;
import java.util.Optional;

/**
 * One progress bar for a whole benchmark, with the time left. What is measured is kept on the disk as it comes, where
 * files were asked for: a process that ends before its time, by a driver's hand perhaps, may not be asked for it any
 * more. Where it may, it says where that was, and what is left.
 */
public final class BenchmarkLine implements BenchmarkProgress, AutoCloseable {
    private final PrintWriter out;
    private final PrintWriter err;
    private final BenchmarkPlan plan;
    private final ReportFiles files;
    private final ProgressLine line;
    private final BenchmarkBar bar;
    private final Thread hook = Thread.ofPlatform().name("unfinished").unstarted(() -> LastWrites.run(this::giveUp));
    private volatile String engine = "benchmark";
    private volatile String task = engine;
    private Optional<BenchmarkReport> latest = Optional.empty();
    private boolean ended;

    /**
     * Shows the bar.
     *
     * @param stepsToStart of the bodies before each setting's first frame
     */
    public BenchmarkLine(PrintWriter out, PrintWriter err, BenchmarkPlan plan, int stepsToStart, ReportFiles files) {
        this.out = out;
        this.err = err;
        this.plan = plan;
        this.files = files;
        long settings = plan.settings().size();
        long engines = plan.engines().size();
        line = ProgressLine.start(
                err, "benchmark", settings + engines * (1 + settings * (stepsToStart + plan.framesEach())));
        bar = new BenchmarkBar(line);
        Runtime.getRuntime().addShutdownHook(hook);
    }

    @Override
    public void begins(String engine, PictureSize size, int frames) {
        this.engine = engine;
        task = engine + " " + size;
        bar.begins(engine, size, frames);
    }

    @Override
    public void drewFrame() {
        bar.drewFrame();
    }

    @Override
    public void leavesOut(String engine, Setting setting, double seconds) {
        bar.begins(engine, setting.size(), plan.framesEach());
        line.clear();
        err.printf(
                Locale.ROOT,
                "twister: %s at %s is left out: a frame takes about %.0f s, and --max-seconds is %s%n",
                engine,
                setting.size(),
                seconds,
                ReportNumbers.shortest(plan.maxSeconds()));
        err.flush();
    }

    @Override
    public synchronized void found(BenchmarkReport soFar) {
        if (!ended) {
            latest = Optional.of(soFar);
            files.writeUnfinished(soFar);
        }
    }

    /** What is left to say where the benchmark ends before its time; writes no more after that. */
    synchronized void giveUp() {
        ended = true;
        line.close();
        String end = "ended at " + task + ", before the benchmark was done";
        latest.map(report -> report.with(new EngineFailure(engine, end)))
                .filter(report -> !report.measurements().isEmpty())
                .ifPresentOrElse(
                        report -> {
                            err.println("twister: " + end + "; " + files.writeUnfinished(report));
                            out.println(ReportTable.of(report));
                        },
                        () -> err.println("twister: " + end + "; nothing was measured"));
        err.flush();
        out.flush();
    }

    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException _) {
            // The process ends already: the hook has spoken, or will.
        }
        line.close();
    }

    /** Shows on a progress line what is measured, and how far that is. */
    public static final class BenchmarkBar implements BenchmarkProgress {
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
}
