package dev.twister.bench.benchmark;

import dev.twister.bench.Statistics;
import dev.twister.image.FrameTimes;
import java.util.List;
import java.util.Optional;
import java.util.function.ToLongFunction;

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

    /**
     * Costs of frames with moving bodies, in milliseconds.
     *
     * @param step mean time of a physics step
     * @param rebuild mean time of a snapshot, mostly for rebuilding the hierarchy over the spheres
     * @param drawing time of each frame, in order, because each has other positions
     */
    public record MotionTimes(double step, double rebuild, List<Double> drawing) {
        public MotionTimes {
            drawing = List.copyOf(drawing);
        }
    }

    /** Mean times of the measured frames on a device, in milliseconds. */
    public record DeviceTimes(double kernel, double copyIn, double copyOut) {
        private static final double NANOS_PER_MILLI = 1e6;

        /** Empty on the JVM, where the kernel's time is that of the whole frame. */
        static Optional<DeviceTimes> meanOf(List<FrameTimes> frames) {
            boolean onJvm = frames.stream()
                    .allMatch(frame -> frame.equals(FrameTimes.onJvm(frame.totalNanos(), frame.processorNanos())));
            return onJvm
                    ? Optional.empty()
                    : Optional.of(new DeviceTimes(
                            mean(frames, FrameTimes::kernelNanos),
                            mean(frames, FrameTimes::copyInNanos),
                            mean(frames, FrameTimes::copyOutNanos)));
        }

        private static double mean(List<FrameTimes> frames, ToLongFunction<FrameTimes> nanos) {
            return frames.stream().mapToLong(nanos).average().orElse(0) / NANOS_PER_MILLI;
        }
    }
}
