package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Draws the same frame again and again within a time. */
final class FrameLoop {
    private static final double NANOS_PER_SECOND = 1e9;

    private final Engine engine;
    private final FrameInput input;
    private final Frame frame;
    private final BenchmarkProgress progress;
    private final double maxSeconds;
    private final long start = System.nanoTime();

    FrameLoop(Engine engine, FrameInput input, Frame frame, BenchmarkProgress progress, double maxSeconds) {
        this.engine = engine;
        this.input = input;
        this.frame = frame;
        this.progress = progress;
        this.maxSeconds = maxSeconds;
    }

    /** Draws frames that do not count, for half of the time at most, but one in any case; returns how many. */
    int warmUp(int frames) {
        int drawn = 0;
        while (drawn < frames && (drawn == 0 || seconds() < maxSeconds / 2)) {
            draw();
            drawn++;
        }
        return drawn;
    }

    /** Draws frames that count, for what is left of the time, but one in any case. */
    MeasuredFrames measure(int frames) {
        List<FrameTimes> times = new ArrayList<>();
        // An engine that left pixels unwritten would show the warm-up's: what is compared is drawn over nothing.
        Arrays.fill(frame.argb(), 0);
        while (times.size() < frames && (times.isEmpty() || seconds() < maxSeconds)) {
            draw();
            times.add(frame.times());
        }
        return new MeasuredFrames(times);
    }

    private void draw() {
        engine.render(input, frame);
        progress.drewFrame();
    }

    private double seconds() {
        return (System.nanoTime() - start) / NANOS_PER_SECOND;
    }
}
