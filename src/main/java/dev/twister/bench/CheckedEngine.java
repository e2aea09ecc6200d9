package dev.twister.bench;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What the check of one engine found.
 *
 * @param driver the version of the device's driver
 * @param compileSeconds by how much a device's first frame took longer than its second
 * @param scenes its pictures of the scenes, until it failed
 * @param timed its measurements; empty where it did not come to them
 * @param obstacle why the engine does not work here
 * @param failure why it did not finish
 */
public record CheckedEngine(
        String engine,
        String device,
        Optional<String> driver,
        Optional<Double> compileSeconds,
        List<CheckedPicture> scenes,
        Optional<BenchmarkReport> timed,
        Optional<String> obstacle,
        Optional<String> failure) {
    public CheckedEngine {
        scenes = List.copyOf(scenes);
    }

    /** Whether it finished with the reference's pictures, or does not work here and was not tried. */
    public boolean passed() {
        return failure.isEmpty() && wrongPictures().isEmpty();
    }

    /** All its pictures, those that were measured too. */
    List<CheckedPicture> pictures() {
        Stream<CheckedPicture> measured = timed.stream()
                .flatMap(report -> report.measurements().stream()
                        .map(measurement -> new CheckedPicture(
                                report.scene() + " " + measurement.setting(), measurement.comparison())));
        return Stream.concat(scenes.stream(), measured).toList();
    }

    List<CheckedPicture> wrongPictures() {
        return pictures().stream()
                .filter(picture -> !picture.comparison().withinTolerance())
                .toList();
    }

    /** At a setting; empty where it was not measured. */
    Optional<Measurement> at(Setting setting) {
        return timed.flatMap(report -> report.find(engine, setting));
    }
}
