package dev.twister.bench.benchmark;

import dev.twister.engine.SettlingFrames;
import dev.twister.image.PictureSize;
import dev.twister.world.FrameInput;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Warms up an engine before its first measured frame. Full-size frames alone are too few for the JIT compiler on a slow
 * machine.
 *
 * @param maxSeconds limit per input; at least one frame is rendered
 */
record EngineWarmUp(double maxSeconds, BenchmarkProgress progress) {
    private static final double NANOS_PER_SECOND = TimeUnit.SECONDS.toNanos(1);

    /**
     * Renders small frames of each input until their times settle. Skipped for devices, which compile no faster code
     * later; they try work-groups in their first 6 frames, of the size that is measured.
     */
    void run(AskedEngine asked, PictureSize size, List<FrameInput> inputs) {
        if (!asked.isDevice()) {
            progress.begins(asked.id() + ", warming up,", size, 1);
            Duration each = Duration.ofNanos((long) (maxSeconds * NANOS_PER_SECOND));
            inputs.forEach(
                    input -> new SettlingFrames(asked.engine(), SettlingFrames.small(input)).settle(each, () -> false));
            progress.drewFrame();
        }
    }
}
