package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** The first frames of an engine, which get faster while compilers work. */
public final class SettlingFrames {
    /** Width in pixels; large enough that a device's fixed cost per frame does not dominate. */
    private static final int SMALL_WIDTH = 320;

    private final Engine engine;
    private final FrameInput input;
    private final Frame frame;
    private final BestTime best;
    private final Optional<CompilationMXBean> compiler = Optional.ofNullable(ManagementFactory.getCompilationMXBean())
            .filter(CompilationMXBean::isCompilationTimeMonitoringSupported);
    private long compiledMillis;

    /** Frames of one input, with a new {@link BestTime}. */
    public SettlingFrames(Engine engine, FrameInput input) {
        this(engine, input, new BestTime());
    }

    /** As above, with a shared {@link BestTime}. */
    public SettlingFrames(Engine engine, FrameInput input, BestTime best) {
        this.engine = engine;
        this.input = input;
        this.best = best;
        frame = input.layers() > 0
                ? Frame.ofRadiance(input.width(), input.rows(), input.layers())
                : Frame.ofPixels(input.width(), input.rows());
    }

    /**
     * The same view with few pixels. The JVM compiles the same code for it, but sooner, because an engine may be
     * hundreds of times slower before that.
     */
    public static FrameInput small(FrameInput input) {
        int width = Math.min(SMALL_WIDTH, input.width());
        int height = Math.max(1, (int) ((long) width * input.height() / input.width()));
        return input.withSize(width, height);
    }

    /**
     * Renders one frame.
     *
     * @return the frame's time, see {@link FrameTimes#effortNanos}
     */
    public Duration draw() {
        engine.render(input, frame);
        long nanos = frame.times().effortNanos();
        best.add(nanos, hasCompiled());
        return Duration.ofNanos(nanos);
    }

    /**
     * Renders at least one frame, and more until frame times settle.
     *
     * @param longest limit of the total time
     * @param unwanted whether to stop early
     */
    public void settle(Duration longest, BooleanSupplier unwanted) {
        long start = System.nanoTime();
        do {
            draw();
        } while (!areSettled() && !unwanted.getAsBoolean() && System.nanoTime() - start < longest.toNanos());
    }

    /** Whether frame times have settled. */
    public boolean areSettled() {
        return best.isSettled();
    }

    /** Whether the JIT compiler has finished code since the last call; faster frames may follow. */
    private boolean hasCompiled() {
        long before = compiledMillis;
        compiledMillis =
                compiler.map(CompilationMXBean::getTotalCompilationTime).orElse(before);
        return compiledMillis > before;
    }
}
