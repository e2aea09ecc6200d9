package dev.twister.cli;

import dev.twister.bench.BenchmarkEngines;
import dev.twister.bench.EngineFailure;
import dev.twister.bench.PaperBenchmark;
import dev.twister.bench.PaperFolder;
import dev.twister.bench.PaperPlan;
import dev.twister.bench.PaperReport;
import dev.twister.bench.PaperSetting;
import dev.twister.files.PrintableText;
import dev.twister.world.World;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;

/** Runs the paper's evaluation into a folder. */
final class PaperEvaluation {
    private PaperEvaluation() {}

    /** Makes the folder where it is not there, before the work rather than after it. */
    static void prepare(Path folder) throws IOException {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new BadInputException("--output is " + folder + ", but must be a folder");
        }
        PaperFolder.make(folder);
        OutputFile.check("--output", folder.resolve(PaperFolder.PAGE));
    }

    /** Returns the exit code. */
    static int run(PaperPlan plan, String scene, World world, Path folder, PrintWriter out, PrintWriter err)
            throws IOException {
        PaperReport report;
        KeptNumbers kept = new KeptNumbers(folder);
        try (PaperLine line = new PaperLine(err, plan, kept::end)) {
            report = PaperBenchmark.run(BenchmarkEngines::open, plan, scene, world, line, kept::keep);
        }
        Path page = PaperFolder.write(report, folder);
        out.println(
                PrintableText.line(page.toString()) + ": " + report.engines().size() + " engines at "
                        + plan.settings().size() + " settings; beside it JSON, CSV, plots and pictures");
        for (EngineFailure failure : report.failures()) {
            out.println("FAILED: " + failure.engine() + ": " + failure.message());
        }
        report.measurements().stream()
                .filter(measurement -> !measurement.comparison().withinTolerance())
                .forEach(measurement -> out.println("FAILED: " + measurement.engine() + " at "
                        + new PaperSetting(measurement.size(), measurement.shadowSamples(), measurement.bounces())
                        + " draws another picture"));
        return report.passed() ? Main.OK : Main.FAILED;
    }
}
