package dev.twister.bench.report;

import dev.twister.files.InputFile;
import dev.twister.files.SystemReason;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Reads what {@link JsonReport} has written: a report, or lines of reports. */
public final class ReportReader {
    private static final int MAX_BYTES = 256 << 20;
    private static final String NO_RESULTS = ": holds no results of 'twister benchmark --json'";

    private ReportReader() {}

    /**
     * The rows of all reports in a file.
     *
     * @throws IOException naming the file and what is wrong with it
     */
    static List<TimedRow> rows(Path file) throws IOException {
        List<TimedRow> rows = reports(file).stream()
                .flatMap(report -> results(report).stream().flatMap(row -> timed(scene(report), row).stream()))
                .toList();
        if (rows.isEmpty()) {
            throw new IOException(file + NO_RESULTS);
        }
        return rows;
    }

    /**
     * The reports in a file.
     *
     * @throws IOException naming the file and what is wrong with it
     */
    public static List<JsonNode> reports(Path file) throws IOException {
        List<JsonNode> reports = new ArrayList<>();
        try (var values = new JsonMapper().readerFor(JsonNode.class).<JsonNode>readValues(bytes(file))) {
            while (values.hasNextValue()) {
                int line = values.currentLocation().getLineNr();
                JsonNode report = values.nextValue();
                checkResults(report, file + ": line " + line + ": ");
                reports.add(report);
            }
        } catch (JacksonException problem) {
            throw new IOException(file + ": not valid JSON: " + problem.getOriginalMessage(), problem);
        }
        if (reports.stream().allMatch(report -> results(report).isEmpty())) {
            throw new IOException(file + NO_RESULTS);
        }
        return reports;
    }

    /** Results are objects of numbers, texts and truth values. */
    private static void checkResults(JsonNode report, String place) throws IOException {
        int index = 0;
        for (JsonNode row : results(report)) {
            String name = "result " + (index + 1);
            if (!row.isObject()) {
                throw new IOException(place + name + " must be an object");
            }
            for (Map.Entry<String, JsonNode> field : row.properties()) {
                if (field.getValue().isContainer()) {
                    throw new IOException(place + name + ": " + field.getKey() + " must be a number or a text, but is "
                            + (field.getValue().isArray() ? "a list" : "an object"));
                }
            }
            index++;
        }
    }

    /** The rows of a report, of all its figures. */
    public static List<JsonNode> results(JsonNode report) {
        List<JsonNode> rows = new ArrayList<>();
        report.path("results").forEach(rows::add);
        report.path("figures").forEach(figure -> figure.forEach(rows::add));
        return rows;
    }

    /** The scene that was measured. */
    public static String scene(JsonNode report) {
        return report.path("parameters").path("scene").asString("?");
    }

    /** Shadow samples and bounces, or paths per pixel. */
    public static String quality(JsonNode row) {
        return row.has("samplesPerPixel")
                ? row.path("samplesPerPixel").asString() + " paths"
                : row.path("shadowSamples").asString() + "/"
                        + row.path("bounces").asString();
    }

    private static byte[] bytes(Path file) throws IOException {
        String problem = InputFile.problem(file).orElse("");
        if (!problem.isEmpty()) {
            throw new IOException(file + ": " + problem);
        }
        try {
            if (Files.size(file) > MAX_BYTES) {
                throw new IOException(file + ": has more than " + MAX_BYTES + " bytes");
            }
            return Files.readAllBytes(file);
        } catch (IOException failure) {
            throw new IOException(file + ": " + SystemReason.of(failure), failure);
        }
    }

    private static Optional<TimedRow> timed(String scene, JsonNode row) {
        return row.path("frames").asInt(0) > 0 && row.path("msMedian").asDouble(0) > 0
                ? Optional.of(new TimedRow(
                        String.format(
                                "%s %s %dx%d %s",
                                scene,
                                row.path("engine").asString("?"),
                                row.path("width").asInt(0),
                                row.path("height").asInt(0),
                                quality(row)),
                        row.path("frames").asInt(),
                        row.path("msMedian").asDouble(),
                        row.path("msP95").asDouble(row.path("msMedian").asDouble()),
                        row.path("samePicture").asBoolean(true)))
                : Optional.empty();
    }

    /**
     * One engine at one setting, as a report has it.
     *
     * @param name what is the same in two reports that can be compared: scene, engine, size and quality
     * @param frames that were measured
     * @param medianMillis of a frame
     * @param p95Millis below which 95 % of the frames are
     * @param samePicture whether the picture was that of {@code sequential}
     */
    record TimedRow(String name, int frames, double medianMillis, double p95Millis, boolean samePicture) {
        /** The standard deviation of a normal distribution is this many times below its 95th percentile. */
        private static final double P95_DEVIATIONS = 1.645;

        /** The standard error of a median over that of a mean. */
        private static final double MEDIAN_FACTOR = 1.253;

        /** Standard error of the median, as a share of it, estimated from the 95th percentile. */
        double relativeError() {
            double deviation = Math.max(0, p95Millis - medianMillis) / P95_DEVIATIONS;
            return MEDIAN_FACTOR * deviation / Math.sqrt(frames) / medianMillis;
        }
    }
}
