package dev.twister.bench.results;

import dev.twister.bench.ReportNumbers;
import dev.twister.bench.report.JsonReport;
import dev.twister.bench.report.ReportReader;
import dev.twister.image.PictureSize;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.databind.JsonNode;

/**
 * The results of any number of reports, of any machines.
 *
 * @param rows those whose picture was that of {@code sequential}
 * @param refused the others, one line each
 * @param logs the reports as JSON, by the name of the file that they get
 */
record SharedResults(List<ResultRow> rows, List<String> refused, Map<String, String> logs) {
    private static final int DAY = "2026-01-31".length();

    /**
     * Reads files of {@link JsonReport}.
     *
     * @throws IOException naming the file and what is wrong with it
     */
    static SharedResults of(List<Path> files) throws IOException {
        SharedResults results = new SharedResults(new ArrayList<>(), new ArrayList<>(), new LinkedHashMap<>());
        for (Path file : files) {
            for (JsonNode report : ReportReader.reports(file)) {
                String log = "report-" + (results.logs.size() + 1) + ".json";
                results.logs.put(log, report.toPrettyString());
                results.add(report, log);
            }
        }
        return results;
    }

    private void add(JsonNode report, String log) {
        JsonNode machine = report.path("machine");
        String processor = machine.path("processor").asString("?") + ", "
                + ReportNumbers.counted(machine.path("cores").asInt(0), "core");
        String time = report.path("time").asString("");
        String made = machine.path("twister").asString("?") + ", " + time.substring(0, Math.min(DAY, time.length()));
        Map<List<String>, Map<PictureSize, Double>> fps = new LinkedHashMap<>();
        for (JsonNode row : ReportReader.results(report)) {
            String device = row.path("device").asString("?");
            String engine = row.path("engine").asString("?");
            int width = row.path("width").asInt(0);
            int height = row.path("height").asInt(0);
            String name = log + ": " + engine + " on " + device + " at " + width + "x" + height;
            if (width < 1 || height < 1 || row.path("fps").asDouble(0) <= 0) {
                refused.add(name + " has no size or no frame rate");
            } else if (!row.path("samePicture").asBoolean(false)) {
                refused.add(name + " rendered another picture than sequential, or none was compared");
            } else {
                fps.computeIfAbsent(List.of(device, engine, ReportReader.quality(row)), _ -> new LinkedHashMap<>())
                        .put(new PictureSize(width, height), row.path("fps").asDouble());
            }
        }
        fps.forEach((key, bySize) -> rows.add(new ResultRow(
                processor, key.get(0), key.get(1), ReportReader.scene(report), key.get(2), made, log, bySize)));
    }

    /**
     * What one engine reached on one machine, with one scene and quality.
     *
     * @param machine its processor
     * @param device what the engine ran on
     * @param quality shadow samples and bounces, or paths per pixel
     * @param made version of Twister and the day of the measurement
     * @param log the report's file in the page's folder
     * @param fps frames per second by size
     */
    record ResultRow(
            String machine,
            String device,
            String engine,
            String scene,
            String quality,
            String made,
            String log,
            Map<PictureSize, Double> fps) {
        /** Whether the paper measured the same scene with the same quality. */
        boolean isOfThePaper() {
            return scene.equals("benchmark") && quality.equals("1/1");
        }
    }
}
