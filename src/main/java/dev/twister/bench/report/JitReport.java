package dev.twister.bench.report;

import dev.twister.bench.ReportNumbers;
import dev.twister.bench.benchmark.BenchmarkPlan;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Benchmarks of one plan in several JVMs with different JIT compilers, side by side.
 *
 * @param reports reports of {@link JsonReport} by the compiler's name, in the order of the columns
 */
public record JitReport(Map<String, JsonNode> reports) {
    public JitReport {
        reports = new LinkedHashMap<>(reports);
    }

    /**
     * Reads a report of {@link JsonReport}.
     *
     * @throws IOException if the file cannot be read
     */
    public static JsonNode read(Path file) throws IOException {
        return JsonMapper.builder().build().readTree(Files.readString(file));
    }

    /**
     * Writes all reports to one file, by their compilers' names.
     *
     * @throws IOException as for {@link JsonReport#write}
     */
    public void write(Path file) throws IOException {
        JsonReport.write(new LinkedHashMap<>(reports), file);
    }

    /** Whether every engine finished with the reference's pictures, with each compiler. */
    public boolean passed() {
        return reports.values().stream()
                .allMatch(report -> report.path("passed").asBoolean());
    }

    /** Frames per second by engine, size and compiler, and the first compiler's rate relative to each of the others. */
    public String table() {
        List<String> lines = new ArrayList<>();
        reports.forEach((jit, report) -> lines.add(jit + ": " + machine(report)));
        lines.add("");
        lines.addAll(ReportTable.aligned(rows()));
        reports.forEach(
                (jit, report) -> problems(report).forEach(problem -> lines.add("FAILED with " + jit + ": " + problem)));
        return String.join(System.lineSeparator(), lines);
    }

    private static String machine(JsonNode report) {
        JsonNode machine = report.path("machine");
        return machine.path("jit").asString() + ", JDK " + machine.path("jdk").asString() + " "
                + machine.path("jdkVendor").asString() + ", "
                + machine.path("processor").asString() + ", "
                + machine.path("cores").asInt() + " cores";
    }

    private List<List<String>> rows() {
        List<String> jits = List.copyOf(reports.keySet());
        List<String> titles = new ArrayList<>(List.of("engine", "device", "size"));
        jits.forEach(jit -> titles.add("FPS " + jit));
        jits.stream().skip(1).forEach(jit -> titles.add(jits.getFirst() + " / " + jit));
        List<List<String>> rows = new ArrayList<>();
        rows.add(titles);
        reports.values().stream()
                .flatMap(JitReport::results)
                .map(Key::of)
                .distinct()
                .map(this::row)
                .forEach(rows::add);
        return rows;
    }

    private List<String> row(Key key) {
        List<Optional<Double>> rates =
                reports.values().stream().map(report -> fps(report, key)).toList();
        List<String> row = new ArrayList<>(List.of(key.engine(), ReportTable.shortened(key.device()), key.size()));
        rates.forEach(rate -> row.add(text(rate, 1)));
        Optional<Double> first = rates.getFirst();
        rates.stream().skip(1).forEach(rate -> row.add(text(first.flatMap(of -> rate.map(other -> of / other)), 2)));
        return row;
    }

    /** Identifies a measurement across compilers. */
    private record Key(String engine, String device, String size) {
        static Key of(JsonNode result) {
            return new Key(
                    result.path("engine").asString(),
                    result.path("device").asString(),
                    result.path("width").asInt() + "x" + result.path("height").asInt());
        }
    }

    private static Stream<JsonNode> results(JsonNode report) {
        return report.path("results").valueStream();
    }

    private static Optional<Double> fps(JsonNode report, Key key) {
        return results(report)
                .filter(result -> Key.of(result).equals(key))
                .map(result -> result.path("fps").asDouble())
                .findFirst();
    }

    private static String text(Optional<Double> value, int decimals) {
        return value.map(number -> ReportNumbers.legible(number, decimals)).orElse("-");
    }

    private static Stream<String> problems(JsonNode report) {
        Stream<String> wrong = results(report)
                .filter(result -> !result.path("samePicture").asBoolean())
                .map(Key::of)
                .map(key ->
                        key.engine() + " at " + key.size() + " differs from the picture of " + BenchmarkPlan.REFERENCE);
        Stream<String> failed = report.path("failures")
                .valueStream()
                .map(failure -> failure.path("engine").asString() + ": "
                        + failure.path("message").asString());
        return Stream.concat(wrong, failed);
    }
}
