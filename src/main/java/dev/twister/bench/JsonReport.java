package dev.twister.bench;

import dev.twister.files.WholeFile;
import dev.twister.image.PictureSize;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;

/** A report for programs, whole, as JSON. */
public final class JsonReport {
    private JsonReport() {}

    /**
     * Writes the report, whole or not at all.
     *
     * @throws IOException as {@link WholeFile#write}
     */
    public static void write(BenchmarkReport report, Path file) throws IOException {
        byte[] json = JsonMapper.builder()
                .enable(SerializationFeature.INDENT_OUTPUT)
                .build()
                .writeValueAsBytes(tree(report));
        WholeFile.write(file, out -> {
            out.write(json);
            out.write('\n');
        });
    }

    private static Map<String, Object> tree(BenchmarkReport report) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("machine", ReportFields.ofMachine(report.machine()));
        Map<String, Object> parameters = new LinkedHashMap<>(ReportFields.ofPlan(report));
        parameters.put("engines", report.plan().engines());
        parameters.put(
                "sizes",
                report.plan().sizes().stream().map(PictureSize::toString).toList());
        tree.put("parameters", parameters);
        tree.put(
                "results",
                report.measurements().stream()
                        .map(measurement -> ReportFields.ofMeasurement(report, measurement))
                        .toList());
        List<Map<String, String>> failures = report.failures().stream()
                .map(failure -> Map.of("engine", failure.engine(), "message", failure.message()))
                .toList();
        tree.put("failures", failures);
        tree.put("passed", report.passed());
        return tree;
    }
}
