package dev.twister.bench;

import dev.twister.image.Frame;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What a benchmark found.
 *
 * @param scene its name or file
 * @param measurements in any order; kept by setting, as the plan has them, and at one setting as they came
 * @param failures engines that did not finish
 * @param pictures what the reference drew at the {@link BenchmarkPlan#shown} settings; none where bodies move
 * @param finished whether all was measured that the plan has, but what failed
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
        // Each engine is opened once, for all settings; a reader compares engines at one setting.
        List<Setting> settings = plan.settings();
        measurements = measurements.stream()
                .sorted(Comparator.comparingInt(measurement -> settings.indexOf(measurement.setting())))
                .toList();
        failures = List.copyOf(failures);
        pictures = Map.copyOf(pictures);
    }

    /** The same with one failure more. */
    public BenchmarkReport with(EngineFailure failure) {
        List<EngineFailure> all =
                Stream.concat(failures.stream(), Stream.of(failure)).toList();
        return new BenchmarkReport(machine, plan, scene, measurements, all, pictures, finished);
    }

    /** The engines that were measured, in the order of the plan. */
    public List<String> engines() {
        return plan.engines().stream()
                .filter(engine -> measurements.stream()
                        .anyMatch(measurement -> measurement.engine().equals(engine)))
                .toList();
    }

    /** An engine at a setting; empty where it was not measured. */
    public Optional<Measurement> find(String engine, Setting setting) {
        return measurements.stream()
                .filter(measurement -> measurement.engine().equals(engine)
                        && measurement.setting().equals(setting))
                .findFirst();
    }

    /** An engine's frames a second at a setting; empty where it was not measured. */
    Optional<Double> fps(String engine, Setting setting) {
        return find(engine, setting).map(measurement -> measurement.times().fps());
    }

    /**
     * How many times faster than the baseline, by the means of the same frames; empty where that one was not measured.
     */
    public Optional<Double> speedupOver(String baseline, Measurement measurement) {
        return find(baseline, measurement.setting()).map(other -> speedup(other, measurement));
    }

    private static double speedup(Measurement baseline, Measurement measurement) {
        int frames = Math.min(baseline.times().frames(), measurement.times().frames());
        return baseline.meanOfFirst(frames) / measurement.meanOfFirst(frames);
    }

    /** What is wrong, a line each: other pictures than the reference's, and engines that failed. */
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
                "%s at %s draws another picture than %s: %d of %d pixels differ by more than %d of 255 (%d may), by %d at"
                        + " most",
                measurement.engine(),
                measurement.setting(),
                Benchmark.REFERENCE,
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
