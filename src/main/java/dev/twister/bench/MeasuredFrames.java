package dev.twister.bench;

import dev.twister.image.FrameTimes;
import java.util.List;
import java.util.Optional;

/** The times of the frames that count. */
record MeasuredFrames(List<FrameTimes> times) {
    private static final double NANOS_PER_MILLI = 1e6;

    MeasuredFrames {
        times = List.copyOf(times);
    }

    Statistics statistics() {
        return Statistics.ofNanos(
                times.stream().mapToLong(FrameTimes::totalNanos).toArray());
    }

    /** As they came. */
    List<Double> millis() {
        return times.stream().map(frame -> frame.totalNanos() / NANOS_PER_MILLI).toList();
    }

    /** Empty on the JVM, where the kernel's time is the whole. */
    Optional<DeviceTimes> deviceTimes() {
        boolean onJvm = times.stream().allMatch(frame -> frame.equals(FrameTimes.onJvm(frame.totalNanos())));
        return onJvm ? Optional.empty() : Optional.of(DeviceTimes.meanOf(times));
    }
}
