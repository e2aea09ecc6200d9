package dev.twister.bench.device;

import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.Measurement;
import dev.twister.bench.benchmark.PictureComparison;
import dev.twister.bench.benchmark.Setting;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The result of checking one engine.
 *
 * @param driver version of the device's driver
 * @param compileSeconds time by which a device's first frame exceeded its second one
 * @param scenes comparisons of its pictures of the scenes, until it failed
 * @param timed its measurements; empty if it failed before
 * @param obstacle why the engine cannot run here
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

    /** Whether it finished with the reference's pictures, or cannot run here and was skipped. */
    public boolean passed() {
        return failure.isEmpty() && wrongPictures().isEmpty();
    }

    /** All comparisons, including those of the measurements. */
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

    /** The measurement at a setting; empty if there is none. */
    Optional<Measurement> at(Setting setting) {
        return timed.flatMap(report -> report.find(engine, setting));
    }

    /** A picture of a check, compared with the reference's. */
    record CheckedPicture(String name, PictureComparison comparison) {
        /** Its name and the number of differing pixels. */
        String difference() {
            return name + " " + comparison.differingPixels() + " of " + comparison.pixels() + " ("
                    + comparison.allowedPixels() + " may)";
        }
    }
}
