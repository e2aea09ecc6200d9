package dev.twister.bench;

import dev.twister.files.InputFile;
import dev.twister.files.SystemReason;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Reads what {@link JsonReport} has written: a report, or lines of reports. */
final class ReportReader {
    private static final int MAX_BYTES = 256 << 20;

    private final Path file;
    private final List<TimedRow> rows = new ArrayList<>();

    private ReportReader(Path file) {
        this.file = file;
    }

    /**
     * The rows of all reports in a file.
     *
     * @throws IOException naming the file and what is wrong with it
     */
    static List<TimedRow> rows(Path file) throws IOException {
        ReportReader reader = new ReportReader(file);
        try (var reports = new JsonMapper().readerFor(JsonNode.class).<JsonNode>readValues(reader.bytes())) {
            while (reports.hasNextValue()) {
                reader.add(reports.nextValue());
            }
        } catch (JacksonException problem) {
            throw new IOException(file + ": not valid JSON: " + problem.getOriginalMessage(), problem);
        }
        if (reader.rows.isEmpty()) {
            throw new IOException(file + ": holds no results of 'twister benchmark --json'");
        }
        return reader.rows;
    }

    private byte[] bytes() throws IOException {
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

    private void add(JsonNode report) {
        String scene = report.path("parameters").path("scene").asString("?");
        report.path("results").forEach(row -> add(scene, row));
        report.path("figures").forEach(figure -> figure.forEach(row -> add(scene, row)));
    }

    private void add(String scene, JsonNode row) {
        if (row.path("frames").asInt(0) > 0 && row.path("msMedian").asDouble(0) > 0) {
            String quality = row.has("samplesPerPixel")
                    ? row.path("samplesPerPixel").asString() + " paths"
                    : row.path("shadowSamples").asString() + "/"
                            + row.path("bounces").asString();
            rows.add(new TimedRow(
                    String.format(
                            "%s %s %dx%d %s",
                            scene,
                            row.path("engine").asString("?"),
                            row.path("width").asInt(0),
                            row.path("height").asInt(0),
                            quality),
                    row.path("frames").asInt(),
                    row.path("msMedian").asDouble(),
                    row.path("msP95").asDouble(row.path("msMedian").asDouble()),
                    row.path("samePicture").asBoolean(true)));
        }
    }
}
