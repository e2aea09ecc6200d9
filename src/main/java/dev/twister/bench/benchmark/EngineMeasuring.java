package dev.twister.bench.benchmark;

import dev.twister.bench.Statistics;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;

/** Measures an engine at a setting: warm-up frames, then measured ones. */
record EngineMeasuring(AskedEngine asked, BenchmarkPlan plan, BenchmarkProgress progress) {
    private static final double NANOS_PER_MILLI = 1e6;
    private static final double NANOS_PER_SECOND = 1e9;

    /** In which the TornadoVM engine tries work-groups: {@code WorkGroups}. */
    private static final int FIRST_OF_A_DEVICE = 6;

    /**
     * Renders the bodies at rest, then in motion if they move: the same frames for every engine, regardless of the
     * number of warm-up frames.
     *
     * @param reference renders the reference of the last frame
     */
    Measurement measure(Setting setting, MeasuredBodies bodies, Function<FrameInput, int[]> reference) {
        progress.begins(asked.id(), setting.size(), plan.framesEach());
        Frame frame = Frame.ofPixels(setting.size().width(), setting.size().height());
        long start = System.nanoTime();
        int warmups = 0;
        while (warmups < plan.warmupFrames() && (warmups < fewestWarmups() || isWithin(start, plan.maxSeconds() / 2))) {
            draw(bodies.rehearse(), frame);
            warmups++;
        }
        // Cleared, so that pixels that an engine does not write are detected.
        Arrays.fill(frame.argb(), 0);
        List<FrameTimes> times = new ArrayList<>();
        while (times.size() < plan.frames() && (times.isEmpty() || isWithin(start, plan.maxSeconds()))) {
            draw(bodies.next(), frame);
            times.add(frame.times());
        }
        return new Measurement(
                asked.id(),
                asked.device(),
                setting,
                bodies.input().bodyCount(),
                warmups,
                Statistics.ofNanos(
                        times.stream().mapToLong(FrameTimes::totalNanos).toArray()),
                DeviceTimes.meanOf(times),
                PictureComparison.of(reference.apply(bodies.input()), frame.argb()),
                bodies.times(times.stream()
                        .map(time -> time.totalNanos() / NANOS_PER_MILLI)
                        .toList()));
    }

    private void draw(FrameInput input, Frame frame) {
        asked.engine().render(input, frame);
        progress.drewFrame();
    }

    private int fewestWarmups() {
        return asked.isDevice() ? FIRST_OF_A_DEVICE : 1;
    }

    private static boolean isWithin(long start, double seconds) {
        return (System.nanoTime() - start) / NANOS_PER_SECOND < seconds;
    }
}
