package dev.twister.bench;

import java.util.List;
import java.util.Optional;

/**
 * What a benchmark found.
 *
 * @param scene its name or file
 * @param measurements by size, then by engine, as the plan has them
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
        measurements = List.copyOf(measurements);
        failures = List.copyOf(failures);
    }

    @Override
    public Optional<Double> speedupOver(String baseline, Measurement measurement) {
        return measurements.stream()
                .filter(other -> other.engine().equals(baseline) && other.size().equals(measurement.size()))
                .findFirst()
                .map(other -> other.times().mean() / measurement.times().mean());
    }

    /** Whether every engine finished with sequential's picture. */
    public boolean passed() {
        return failures.isEmpty()
                && measurements.stream()
                        .allMatch(measurement -> measurement.comparison().withinTolerance());
    }
}
