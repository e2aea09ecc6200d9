package dev.twister.bench.report;

import dev.twister.bench.PublishedFigures;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.PaperFigure;
import dev.twister.bench.benchmark.Setting;
import dev.twister.files.LinesFile;
import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;

/** Writes a report as JSON, with the results, or those of each figure if there are several. */
public final class JsonReport {
    /** Suffix of JSON Lines files, with one report per line. */
    private static final String LINES = ".jsonl";

    private JsonReport() {}

    /**
     * Writes the report; on failure the file is unchanged. If the file's name ends in {@value #LINES}, the report is
     * appended as a line; several processes may do so at once.
     *
     * @throws IOException naming the file and the cause
     */
    public static void write(BenchmarkReport report, Path file) throws IOException {
        write(tree(report), file);
    }

    /** Writes any tree of maps, lists and values in the same way. */
    public static void write(Map<String, Object> tree, Path file) throws IOException {
        boolean isLine = file.toString().endsWith(LINES);
        byte[] json = JsonMapper.builder()
                .configure(SerializationFeature.INDENT_OUTPUT, !isLine)
                .build()
                .writeValueAsBytes(tree);
        if (isLine) {
            LinesFile.append(file, json);
        } else {
            WholeFile.write(file, out -> {
                out.write(json);
                out.write('\n');
            });
        }
    }

    private static Map<String, Object> tree(BenchmarkReport report) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("time", Instant.now().truncatedTo(ChronoUnit.SECONDS).toString());
        tree.put("machine", ReportFields.ofMachine(report.machine()));
        Map<String, Object> parameters = new LinkedHashMap<>(ReportFields.ofPlan(report));
        parameters.put("engines", report.plan().engines());
        parameters.put(
                "sizes",
                report.plan().settings(PaperFigure.SIZES).stream()
                        .map(setting -> setting.size().toString())
                        .toList());
        tree.put("parameters", parameters);
        if (report.plan().hasOneFigure()) {
            tree.put("results", ReportFields.ofFigure(report, PaperFigure.SIZES));
        } else {
            Map<String, Object> figures = new LinkedHashMap<>();
            report.plan()
                    .figures()
                    .keySet()
                    .forEach(figure -> figures.put(figure.id(), ReportFields.ofFigure(report, figure)));
            tree.put("figures", figures);
            tree.put("published", published(report));
        }
        List<Map<String, String>> failures = report.failures().stream()
                .map(failure -> Map.of("engine", failure.engine(), "message", failure.message()))
                .toList();
        tree.put("failures", failures);
        tree.put("finished", report.finished());
        tree.put("passed", report.passed());
        return tree;
    }

    private static Map<String, Object> published(BenchmarkReport report) {
        List<Map<String, Object>> fps = report.plan().settings(PaperFigure.SIZES).stream()
                .map(Setting::size)
                .flatMap(size -> PublishedFigures.fps(size).stream()
                        .map(found -> Map.<String, Object>of("size", size.toString(), "fps", found)))
                .toList();
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("paper", PublishedFigures.PAPER);
        tree.put("device", PublishedFigures.DEVICE);
        tree.put("fpsWithHardShadowsAndOneBounce", fps);
        tree.put("largestSpeedupOverParallel", PublishedFigures.LARGEST_SPEEDUP_OVER_PARALLEL);
        return tree;
    }
}
