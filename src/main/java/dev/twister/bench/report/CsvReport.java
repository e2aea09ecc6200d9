package dev.twister.bench.report;

import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.EngineFailure;
import dev.twister.bench.benchmark.PaperFigure;
import dev.twister.files.WholeFile;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;

/**
 * Writes a report for spreadsheets, with one row per figure, setting and engine. Text that a spreadsheet would take for
 * a formula is preceded by an apostrophe.
 */
public final class CsvReport {
    /** All columns of a measurement. */
    private static final List<String> COLUMNS = List.of(
            ("engine device width height shadowSamples bounces integrator samplesPerPixel bodies warmupFrames frames fps "
                            + "samplesPerSecond msMin msMedian msMean msP95 msKernel msCopyIn msCopyOut msStep msRebuild"
                            + " speedupOverSequential "
                            + "speedupOverParallel differingPixels allowedDifferingPixels largestDifference"
                            + " samePicture "
                            + "failure scene plannedWarmupFrames plannedFrames maxSeconds processor cores memoryBytes "
                            + "maxHeapBytes operatingSystem jdk jdkVendor jit twister tornadoVm finished")
                    .split(" "));

    /** First characters of formulas in spreadsheets. */
    private static final String FORMULA_STARTS = "=+-@\t\r";

    /** The first column, if there are several figures. */
    private static final String FIGURE = "figure";

    private CsvReport() {}

    /**
     * Writes the report; on failure the file is unchanged.
     *
     * @throws IOException as for {@link WholeFile#write}
     */
    public static void write(BenchmarkReport report, Path file) throws IOException {
        List<String> columns = report.plan().hasOneFigure()
                ? COLUMNS
                : Stream.concat(Stream.of(FIGURE), COLUMNS.stream()).toList();
        Map<String, Object> common = new LinkedHashMap<>(ReportFields.ofPlan(report));
        common.putAll(ReportFields.ofMachine(report.machine()));
        common.put("finished", report.finished());
        WholeFile.write(file, out -> {
            CSVPrinter printer = CSVFormat.RFC4180
                    .builder()
                    .setHeader(columns.toArray(String[]::new))
                    .get()
                    .print(new OutputStreamWriter(out, StandardCharsets.UTF_8));
            for (Map<String, Object> row : rows(report)) {
                printer.printRecord(columns.stream()
                        .map(column -> cell(row.getOrDefault(column, common.getOrDefault(column, ""))))
                        .toList());
            }
            printer.flush();
        });
    }

    private static Object cell(Object value) {
        return value instanceof String text && !text.isEmpty() && FORMULA_STARTS.indexOf(text.charAt(0)) >= 0
                ? "'" + text
                : value;
    }

    private static List<Map<String, Object>> rows(BenchmarkReport report) {
        List<Map<String, Object>> rows = new ArrayList<>();
        for (PaperFigure figure : report.plan().figures().keySet()) {
            for (Map<String, Object> row : ReportFields.ofFigure(report, figure)) {
                row.put(FIGURE, figure.id());
                rows.add(row);
            }
        }
        for (EngineFailure failure : report.failures()) {
            rows.add(Map.of("engine", failure.engine(), "failure", failure.message()));
        }
        return rows;
    }
}
