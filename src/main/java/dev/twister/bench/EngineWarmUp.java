package dev.twister.bench;

import dev.twister.engine.SettlingFrames;
import dev.twister.image.PictureSize;
import dev.twister.world.FrameInput;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * What an engine draws before the first picture that is measured. Frames of full size are too few for the JVM's
 * compiler on a slow machine.
 *
 * @param maxSeconds for each input, a frame in any case
 */
record EngineWarmUp(double maxSeconds, BenchmarkProgress progress) {
    private static final double NANOS_PER_SECOND = TimeUnit.SECONDS.toNanos(1);

    /**
     * Draws small pictures of each input in turn until they get no faster; devices, which compile for each size, draw
     * none.
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
