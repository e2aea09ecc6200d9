package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** The first frames of an engine, which get faster as compilers come to what it runs. */
public final class SettlingFrames {
    /** Large enough that what a device takes for each frame, whatever its size, does not hide how fast it is. */
    private static final int SMALL_WIDTH = 320;

    private final Engine engine;
    private final FrameInput input;
    private final Frame frame;
    private final BestTime best;
    private final Optional<CompilationMXBean> compiler = Optional.ofNullable(ManagementFactory.getCompilationMXBean())
            .filter(CompilationMXBean::isCompilationTimeMonitoringSupported);
    private long compiledMillis;

    /** Of one input, and with a time of their own. */
    public SettlingFrames(Engine engine, FrameInput input) {
        this(engine, input, new BestTime());
    }

    /** The same with a time that others see. */
    public SettlingFrames(Engine engine, FrameInput input, BestTime best) {
        this.engine = engine;
        this.input = input;
        this.best = best;
        frame = Frame.ofPixels(input.width(), input.rows());
    }

    /**
     * The same view with few pixels: the JVM compiles the same code for it, and sooner, for before that an engine may
     * be hundreds of times slower.
     */
    public static FrameInput small(FrameInput input) {
        int width = Math.min(SMALL_WIDTH, input.width());
        int height = Math.max(1, (int) ((long) width * input.height() / input.width()));
        return input.withSize(width, height);
    }

    /**
     * Draws one more.
     *
     * @return how long it took
     */
    public Duration draw() {
        engine.render(input, frame);
        long nanos = frame.times().totalNanos();
        best.add(nanos, hasCompiled());
        return Duration.ofNanos(nanos);
    }

    /**
     * Draws one, and more until they get no faster.
     *
     * @param longest for all together
     * @param unwanted whether to stop sooner
     */
    public void settle(Duration longest, BooleanSupplier unwanted) {
        long start = System.nanoTime();
        do {
            draw();
        } while (!areSettled() && !unwanted.getAsBoolean() && System.nanoTime() - start < longest.toNanos());
    }

    /** Whether they are likely to get no faster. */
    public boolean areSettled() {
        return best.isSettled();
    }

    /**
     * Whether the JVM's compiler has finished anything since it was last asked: code that is compiled anew is faster
     * soon.
     */
    private boolean hasCompiled() {
        long before = compiledMillis;
        compiledMillis =
                compiler.map(CompilationMXBean::getTotalCompilationTime).orElse(before);
        return compiledMillis > before;
    }
}
