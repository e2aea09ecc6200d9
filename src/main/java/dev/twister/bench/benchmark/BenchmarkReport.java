package dev.twister.bench.benchmark;

import dev.twister.bench.ReportNumbers;
import dev.twister.image.Frame;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The result of a benchmark.
 *
 * @param scene its name or file
 * @param measurements in any order; stored in the plan's order of settings, and per setting as given
 * @param failures engines that did not finish
 * @param pictures the reference's pictures at the {@link BenchmarkPlan#shown} settings; none if bodies move
 * @param finished whether the whole plan was measured, except for failures
 */
public record BenchmarkReport(
        MachineInfo machine,
        BenchmarkPlan plan,
        String scene,
        List<Measurement> measurements,
        List<EngineFailure> failures,
        Map<Setting, Frame> pictures,
        boolean finished) {
    public BenchmarkReport {
        // Each engine is opened once for all settings, but readers compare engines at one setting.
        List<Setting> settings = plan.settings();
        measurements = measurements.stream()
                .sorted(Comparator.comparingInt(measurement -> settings.indexOf(measurement.setting())))
                .toList();
        failures = List.copyOf(failures);
        pictures = Map.copyOf(pictures);
    }

    /** The same report with another failure. */
    public BenchmarkReport with(EngineFailure failure) {
        List<EngineFailure> all =
                Stream.concat(failures.stream(), Stream.of(failure)).toList();
        return new BenchmarkReport(machine, plan, scene, measurements, all, pictures, finished);
    }

    /** The measured engines, in the order of the plan. */
    public List<String> engines() {
        return plan.engines().stream()
                .filter(engine -> measurements.stream()
                        .anyMatch(measurement -> measurement.engine().equals(engine)))
                .toList();
    }

    /** The measurement of an engine at a setting; empty if there is none. */
    public Optional<Measurement> find(String engine, Setting setting) {
        return measurements.stream()
                .filter(measurement -> measurement.engine().equals(engine)
                        && measurement.setting().equals(setting))
                .findFirst();
    }

    /** An engine's frames per second at a setting; empty if it was not measured. */
    public Optional<Double> fps(String engine, Setting setting) {
        return find(engine, setting).map(measurement -> measurement.times().fps());
    }

    /** The measurement of the fastest engine at a setting; empty if none was measured there. */
    public Optional<Measurement> fastest(Setting setting) {
        return engines().stream()
                .flatMap(engine -> find(engine, setting).stream())
                .max(Comparator.comparingDouble(
                        measurement -> measurement.times().fps()));
    }

    /** Such as "The fastest engine of 15 settings: vector at 14, parallel at 1."; empty where nothing was measured. */
    public String fastestEngines() {
        Map<String, Long> wins = plan.settings().stream()
                .flatMap(setting -> fastest(setting).stream())
                .map(Measurement::engine)
                .collect(Collectors.groupingBy(engine -> engine, LinkedHashMap::new, Collectors.counting()));
        long settings = wins.values().stream().mapToLong(count -> count).sum();
        if (settings == 0) {
            return "";
        }
        String counts = wins.entrySet().stream()
                .sorted(Map.Entry.<String, Long>comparingByValue().reversed())
                .map(win -> win.getKey() + " at " + win.getValue())
                .collect(Collectors.joining(", "));
        return "The fastest engine of " + ReportNumbers.counted((int) settings, "setting") + ": " + counts + ".";
    }

    /**
     * The speed relative to the baseline's, from the mean times of the same frames; empty if the baseline was not
     * measured.
     */
    public Optional<Double> speedupOver(String baseline, Measurement measurement) {
        return find(baseline, measurement.setting()).map(other -> speedup(other, measurement));
    }

    private static double speedup(Measurement baseline, Measurement measurement) {
        int frames = Math.min(baseline.times().frames(), measurement.times().frames());
        return baseline.meanOfFirst(frames) / measurement.meanOfFirst(frames);
    }

    /** All problems, one line each: pictures that differ from the reference's, and failed engines. */
    public List<String> problems() {
        return Stream.concat(
                        measurements.stream()
                                .filter(measurement -> !measurement.comparison().withinTolerance())
                                .map(BenchmarkReport::problem),
                        failures.stream().map(failure -> failure.engine() + ": " + failure.message()))
                .toList();
    }

    private static String problem(Measurement measurement) {
        PictureComparison comparison = measurement.comparison();
        return String.format(
                Locale.ROOT,
                "%s at %s differs from the picture of %s: %d of %d pixels differ by more than %d of 255 (%d may), by"
                        + " %d at"
                        + " most",
                measurement.engine(),
                measurement.setting(),
                BenchmarkPlan.REFERENCE,
                comparison.differingPixels(),
                comparison.pixels(),
                PictureComparison.CHANNEL_TOLERANCE,
                comparison.allowedPixels(),
                comparison.largestDifference());
    }

    /** Whether every engine finished with the reference's pictures. */
    public boolean passed() {
        return finished && problems().isEmpty();
    }
}
