package dev.twister.bench;

import dev.twister.files.WholeFile;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;

/** A report for spreadsheets: a line for each engine and size, with all there is to know on it. */
public final class CsvReport {
    /** Whatever is known of a measurement. */
    static final List<String> COLUMNS = List.of(
            "engine",
            "device",
            "width",
            "height",
            "shadowSamples",
            "bounces",
            "bodies",
            "warmupFrames",
            "frames",
            "fps",
            "msMin",
            "msMedian",
            "msMean",
            "msP95",
            "msKernel",
            "msCopyIn",
            "msCopyOut",
            "msStep",
            "msRebuild",
            "speedupOverSequential",
            "speedupOverParallel",
            "differingPixels",
            "allowedDifferingPixels",
            "largestDifference",
            "samePicture",
            "failure",
            "scene",
            "plannedWarmupFrames",
            "plannedFrames",
            "maxSeconds",
            "processor",
            "cores",
            "memoryBytes",
            "maxHeapBytes",
            "operatingSystem",
            "jdk",
            "jdkVendor",
            "jit",
            "twister",
            "tornadoVm");

    private CsvReport() {}

    /**
     * Writes the report, whole or not at all.
     *
     * @throws IOException as {@link WholeFile#write}
     */
    public static void write(BenchmarkReport report, Path file) throws IOException {
        WholeFile.write(file, out -> {
            Writer writer = new OutputStreamWriter(out, StandardCharsets.UTF_8);
            CSVPrinter printer = CSVFormat.RFC4180
                    .builder()
                    .setHeader(COLUMNS.toArray(String[]::new))
                    .get()
                    .print(writer);
            for (Measurement measurement : report.measurements()) {
                print(printer, report, ReportFields.ofMeasurement(report, measurement));
            }
            for (EngineFailure failure : report.failures()) {
                print(printer, report, Map.of("engine", failure.engine(), "failure", failure.message()));
            }
            printer.flush();
        });
    }

    private static void print(CSVPrinter printer, BenchmarkReport report, Map<String, Object> result)
            throws IOException {
        Map<String, Object> fields = new LinkedHashMap<>(ReportFields.ofPlan(report));
        fields.putAll(ReportFields.ofMachine(report.machine()));
        fields.putAll(result);
        printer.printRecord(
                COLUMNS.stream().map(column -> fields.getOrDefault(column, "")).toList());
    }
}
