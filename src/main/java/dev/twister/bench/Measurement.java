package dev.twister.bench;

import java.util.Optional;

/**
 * One engine at one setting.
 *
 * @param engine the id that was asked for
 * @param device what did the work, after the engine's own id where it has another one
 * @param bodies light, plane and spheres
 * @param warmupFrames really drawn before the measured ones
 * @param times of the measured frames, from the call to the pixels in the caller's array
 * @param deviceTimes where the engine draws on a device
 * @param comparison with sequential's picture
 * @param motionTimes where bodies move
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
     * The mean time of the first frames in milliseconds, by which engines compare: of the first ones where bodies move,
     * as an engine that had time for more went on with other bodies; otherwise of all, which are alike.
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
