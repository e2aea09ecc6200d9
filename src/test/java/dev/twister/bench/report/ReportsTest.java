package dev.twister.bench.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.bench.ReportNumbers;
import dev.twister.bench.Statistics;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.BenchmarkTest;
import dev.twister.bench.benchmark.EngineFailure;
import dev.twister.bench.benchmark.Measurement;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class ReportsTest {
    private static final BenchmarkReport REPORT =
            BenchmarkTest.run(BenchmarkTest.plan(List.of("sequential", "device", "broken"), 1, 3, 100));

    @TempDir
    private Path folder;

    @Test
    void reportsOfJsonLinesFollowEachOther() throws IOException {
        Path file = folder.resolve("results.jsonl");
        JsonReport.write(REPORT, file);
        JsonReport.write(REPORT, file);

        List<String> lines = Files.readAllLines(file);
        assertThat(lines).hasSize(2).allSatisfy(line -> {
            JsonNode report = JsonMapper.builder().build().readTree(line);
            assertThat(report.at("/time").asString()).endsWith("Z");
            assertThat(report.at("/results").size()).isEqualTo(4);
        });
    }

    @Test
    void jsonHasEveryFact() throws IOException {
        Path file = folder.resolve("report.json");
        JsonReport.write(REPORT, file);

        JsonNode report = JsonMapper.builder().build().readTree(Files.readString(file));
        assertThat(report.at("/machine").propertyNames())
                .contains("processor", "cores", "memoryBytes", "operatingSystem", "jdk", "jdkVendor", "jit", "twister");
        assertThat(report.at("/parameters/maxSeconds").asDouble()).isEqualTo(100);
        assertThat(report.at("/parameters/sizes/1").asString()).isEqualTo("9x4");
        assertThat(report.at("/results").size()).isEqualTo(4);
        JsonNode device = report.at("/results/1");
        assertThat(device.propertyNames())
                .contains(
                        "engine",
                        "device",
                        "width",
                        "height",
                        "shadowSamples",
                        "bounces",
                        "bodies",
                        "frames",
                        "fps",
                        "msMin",
                        "msMedian",
                        "msMean",
                        "msP95");
        assertThat(device.at("/engine").asString()).isEqualTo("device");
        assertThat(device.at("/msMean").asDouble()).isEqualTo(11);
        assertThat(device.at("/msKernel").asDouble()).isEqualTo(6);
        assertThat(device.at("/speedupOverSequential").asDouble()).isEqualTo(0.727273);
        assertThat(device.has("speedupOverParallel")).isFalse();
        assertThat(device.at("/samePicture").asBoolean()).isTrue();
        assertThat(report.at("/failures/0/message").asString()).isEqualTo("out of order");
        assertThat(report.at("/passed").asBoolean()).isFalse();
    }

    @Test
    void csvHasALineForEveryEngineAndSize() throws IOException {
        Path file = folder.resolve("report.csv");
        CsvReport.write(REPORT, file);

        List<CSVRecord> records = records(file);
        assertThat(records).hasSize(5);
        CSVRecord device = records.get(1);
        assertThat(device.get("engine")).isEqualTo("device");
        assertThat(device.get("width")).isEqualTo("5");
        assertThat(device.get("msMean")).isEqualTo("11.000000");
        assertThat(device.get("msCopyOut")).isEqualTo("3.000000");
        assertThat(device.get("plannedFrames")).isEqualTo("3");
        assertThat(device.get("cores"))
                .isEqualTo(String.valueOf(REPORT.machine().cores()));
        assertThat(records.get(4).get("failure")).isEqualTo("out of order");
    }

    @ParameterizedTest
    @ValueSource(strings = {"=1+1", "+1", "-1", "@now", "\tx", "\rx"})
    void csvHasNoFormulas(String failure) throws IOException {
        Path file = folder.resolve("report.csv");
        CsvReport.write(
                new BenchmarkReport(
                        REPORT.machine(),
                        REPORT.plan(),
                        REPORT.scene(),
                        List.of(),
                        List.of(new EngineFailure("broken", failure)),
                        Map.of(),
                        true),
                file);

        assertThat(records(file).getFirst().get("failure")).isEqualTo("'" + failure);
    }

    @Test
    void csvHasAColumnForEveryFactOfTheJson() throws IOException {
        Path file = folder.resolve("report.csv");
        CsvReport.write(REPORT, file);

        assertThat(records(file).getFirst().getParser().getHeaderNames())
                .containsAll(ReportFields.ofMachine(REPORT.machine()).keySet())
                .containsAll(ReportFields.ofPlan(REPORT).keySet())
                .containsAll(
                        ReportFields.ofMeasurement(REPORT, REPORT.measurements().get(1))
                                .keySet());
    }

    @Test
    void tableIsAligned() {
        List<String> lines = ReportTable.of(REPORT).lines().toList();

        assertThat(lines.get(4)).startsWith("engine      device ").endsWith("x parallel");
        assertThat(lines.subList(4, 9)).allSatisfy(line -> assertThat(line).hasSameSizeAs(lines.get(4)));
        assertThat(lines.getLast()).isEqualTo("FAILED: broken: out of order");
    }

    @Test
    void aSlowEnginesRateIsNotNothing() {
        Measurement minutes = slow("parallel", 52_265.9);
        Measurement seconds = slow("sequential", 200);
        BenchmarkReport report = new BenchmarkReport(
                REPORT.machine(), REPORT.plan(), REPORT.scene(), List.of(seconds, minutes), List.of(), Map.of(), true);

        assertThat(ReportTable.of(report).lines().toList().getLast())
                .containsPattern(" 0\\.019 .* 0\\.0038 ")
                .doesNotContain(" 0.0 ", " 0.00 ");
    }

    @Test
    void theLeadCountsTheSettingsThatEachEngineWins() {
        BenchmarkReport report = new BenchmarkReport(
                REPORT.machine(),
                REPORT.plan(),
                REPORT.scene(),
                List.of(slow("sequential", 200), slow("device", 100)),
                List.of(),
                Map.of(),
                true);

        assertThat(report.fastestEngines()).isEqualTo("The fastest engine of 1 setting: device at 1.");
    }

    @Test
    void quickRatesHaveNoMoreDigitsThanAsked() {
        assertThat(ReportNumbers.legible(1234.56, 1)).isEqualTo("1234.6");
        assertThat(ReportNumbers.legible(5, 1)).isEqualTo("5.0");
        assertThat(ReportNumbers.legible(0.976, 1)).isEqualTo("0.98");
        assertThat(ReportNumbers.legible(0, 1)).isEqualTo("0.0");
    }

    @Test
    void whereThereIsNoFolderNothingIsWritten() {
        assertThatThrownBy(
                        () -> JsonReport.write(REPORT, folder.resolve("missing").resolve("report.json")))
                .isInstanceOf(IOException.class);
    }

    private static Measurement slow(String engine, double millis) {
        Measurement one = REPORT.measurements().getFirst();
        return new Measurement(
                engine,
                one.device(),
                one.setting(),
                one.bodies(),
                1,
                new Statistics(1, millis, millis, millis, millis),
                one.deviceTimes(),
                one.comparison(),
                Optional.empty());
    }

    private static List<CSVRecord> records(Path file) throws IOException {
        try (Reader reader = Files.newBufferedReader(file)) {
            return CSVFormat.RFC4180
                    .builder()
                    .setHeader()
                    .setSkipHeaderRecord(true)
                    .get()
                    .parse(reader)
                    .getRecords();
        }
    }
}
