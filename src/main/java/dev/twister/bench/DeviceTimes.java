package dev.twister.bench;

import dev.twister.image.FrameTimes;
import java.util.List;
import java.util.Optional;
import java.util.function.ToLongFunction;

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
