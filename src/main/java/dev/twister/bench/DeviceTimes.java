package dev.twister.bench;

import dev.twister.image.FrameTimes;
import java.util.List;

/** Where the measured frames' time went on a device, in milliseconds, each the mean over the frames. */
public record DeviceTimes(double kernel, double copyIn, double copyOut) {
    private static final double NANOS_PER_MILLI = 1e6;

    static DeviceTimes meanOf(List<FrameTimes> frames) {
        return new DeviceTimes(
                frames.stream().mapToLong(FrameTimes::kernelNanos).average().orElse(0) / NANOS_PER_MILLI,
                frames.stream().mapToLong(FrameTimes::copyInNanos).average().orElse(0) / NANOS_PER_MILLI,
                frames.stream().mapToLong(FrameTimes::copyOutNanos).average().orElse(0) / NANOS_PER_MILLI);
    }
}
