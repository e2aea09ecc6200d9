package dev.twister.bench.report;

import dev.twister.bench.ReportNumbers;
import dev.twister.bench.Statistics;
import dev.twister.bench.benchmark.MachineInfo;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * What a window showed while its camera moved on a circle.
 *
 * @param engine id of the engine that rendered
 * @param settings of the pictures, with their size
 * @param times from one picture that was shown to the next
 * @param renderedPerSecond pictures that the engine rendered, shown or not
 */
public record WindowRates(
        String engine, String device, Rendering settings, Statistics times, double renderedPerSecond, Display display) {
    /**
     * A screen, as JavaFX sees it.
     *
     * @param scale pixels per unit of the window
     * @param accelerated whether the graphics card paints the window
     * @param pulsesPerSecond how often JavaFX painted it, an upper limit of the pictures shown
     */
    public record Display(int width, int height, double scale, boolean accelerated, double pulsesPerSecond) {}

    /**
     * Writes JSON with the fields of {@code twister benchmark --json}, and the display's; to a {@code .jsonl} file as a
     * line.
     *
     * @param scene its file, or the name of a shipped one
     * @throws IOException naming the file and the cause
     */
    public void write(String scene, Path file) throws IOException {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("time", Instant.now().truncatedTo(ChronoUnit.SECONDS).toString());
        tree.put("machine", ReportFields.ofMachine(MachineInfo.ofThisMachine()));
        Map<String, Object> screen = new LinkedHashMap<>();
        screen.put("width", display.width());
        screen.put("height", display.height());
        screen.put("scale", display.scale());
        screen.put("pipeline", display.accelerated() ? "hardware" : "software");
        screen.put("pulsesPerSecond", ReportNumbers.rounded(display.pulsesPerSecond()));
        tree.put("display", screen);
        tree.put("parameters", Map.of("scene", scene));
        tree.put("results", List.of(result()));
        JsonReport.write(tree, file);
    }

    private Map<String, Object> result() {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("engine", engine);
        fields.put("device", device);
        fields.put("width", settings.width());
        fields.put("height", settings.height());
        if (settings.integrator() == Integrator.PATH) {
            fields.put("integrator", Integrator.PATH.name().toLowerCase(Locale.ROOT));
            fields.put("samplesPerPixel", 1);
        }
        fields.put("shadowSamples", settings.shadowSamples());
        fields.put("bounces", settings.bounces());
        fields.put("frames", times.frames());
        fields.put("fps", ReportNumbers.rounded(times.fps()));
        fields.put("renderedPerSecond", ReportNumbers.rounded(renderedPerSecond));
        ReportFields.putMilliseconds(fields, times);
        return fields;
    }

    /** A line for a person. */
    public String text() {
        return String.format(
                Locale.ROOT,
                "%s (%s), %d x %d: %.1f frames per second shown, %.1f rendered, 95 %% within %.1f ms; %s pipeline,"
                        + " %.1f pulses per second, screen %d x %d",
                engine,
                device,
                settings.width(),
                settings.height(),
                times.fps(),
                renderedPerSecond,
                times.p95(),
                display.accelerated() ? "hardware" : "software",
                display.pulsesPerSecond(),
                display.width(),
                display.height());
    }
}
