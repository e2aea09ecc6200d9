package dev.twister.bench;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * What a benchmark found.
 *
 * @param scene its name or file
 * @param measurements in any order; kept by size, as the plan has them, and within a size as they came
 * @param failures engines that did not finish
 */
public record BenchmarkReport(
        MachineInfo machine,
        BenchmarkPlan plan,
        String scene,
        List<Measurement> measurements,
        List<EngineFailure> failures)
        implements SpeedupSource {
    public BenchmarkReport {
        // Each engine is opened once, for all sizes; a reader compares engines at one size.
        measurements = measurements.stream()
                .sorted(Comparator.comparingInt(measurement -> plan.sizes().indexOf(measurement.size())))
                .toList();
        failures = List.copyOf(failures);
    }

    @Override
    public Optional<Double> speedupOver(String baseline, Measurement measurement) {
        return measurements.stream()
                .filter(other -> other.engine().equals(baseline) && other.size().equals(measurement.size()))
                .findFirst()
                .map(other -> speedup(other, measurement));
    }

    private static double speedup(Measurement baseline, Measurement measurement) {
        int frames = Math.min(baseline.times().frames(), measurement.times().frames());
        return baseline.meanOfFirst(frames) / measurement.meanOfFirst(frames);
    }

    /** Whether every engine finished with sequential's picture. */
    public boolean passed() {
        return failures.isEmpty()
                && measurements.stream()
                        .allMatch(measurement -> measurement.comparison().withinTolerance());
    }
}
