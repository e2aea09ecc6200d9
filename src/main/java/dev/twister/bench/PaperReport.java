package dev.twister.bench;

import java.util.List;
import java.util.Optional;

/**
 * What the paper's evaluation found here.
 *
 * @param scene its name or file
 * @param measurements by engine, then by setting, each setting once
 * @param failures engines that did not finish
 * @param pictures what was drawn
 * @param finished whether all was measured that the plan has, but what failed
 */
public record PaperReport(
        MachineInfo machine,
        PaperPlan plan,
        String scene,
        List<Measurement> measurements,
        List<EngineFailure> failures,
        List<PaperPicture> pictures,
        boolean finished)
        implements SpeedupSource {
    public PaperReport {
        measurements = List.copyOf(measurements);
        failures = List.copyOf(failures);
        pictures = List.copyOf(pictures);
    }

    /** The engines that were measured, in the order of the plan. */
    public List<String> engines() {
        return measurements.stream().map(Measurement::engine).distinct().toList();
    }

    /** An engine at a setting; empty where it failed before. */
    public Optional<Measurement> find(String engine, PaperSetting setting) {
        return measurements.stream()
                .filter(measurement -> measurement.engine().equals(engine)
                        && PaperSetting.of(measurement).equals(setting))
                .findFirst();
    }

    @Override
    public Optional<Double> speedupOver(String baseline, Measurement measurement) {
        return find(baseline, PaperSetting.of(measurement))
                .map(other -> other.times().mean() / measurement.times().mean());
    }

    /** Whether every engine finished with the reference's pictures. */
    public boolean passed() {
        return finished
                && failures.isEmpty()
                && measurements.stream()
                        .allMatch(measurement -> measurement.comparison().withinTolerance());
    }
}
