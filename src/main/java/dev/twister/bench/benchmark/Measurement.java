package dev.twister.bench.benchmark;

import dev.twister.bench.Statistics;
import java.util.Optional;

/**
 * The measurement of one engine at one setting.
 *
 * @param engine the requested id
 * @param device the device, preceded by the engine's own id if that differs
 * @param bodies number of bodies: light, plane and spheres
 * @param warmupFrames number of warm-up frames that were rendered
 * @param times times of the measured frames, from the call to the pixels in the caller's array
 * @param deviceTimes present if the engine runs on a device
 * @param comparison comparison with the reference picture
 * @param motionTimes present if bodies move
 */
public record Measurement(
        String engine,
        String device,
        Setting setting,
        int bodies,
        int warmupFrames,
        Statistics times,
        Optional<DeviceTimes> deviceTimes,
        PictureComparison comparison,
        Optional<MotionTimes> motionTimes) {
    /**
     * The mean time in milliseconds for comparisons of engines. If bodies move, only the first frames count, because
     * later frames of a faster engine have other bodies; otherwise all frames count.
     */
    double meanOfFirst(int frames) {
        return motionTimes
                .map(moving -> moving.drawing().subList(0, frames))
                .map(drawing -> drawing.stream()
                        .mapToDouble(Double::doubleValue)
                        .average()
                        .orElseThrow())
                .orElse(times.mean());
    }
}
