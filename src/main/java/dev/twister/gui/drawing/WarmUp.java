package dev.twister.gui.drawing;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.SettlingFrames;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * The first frames of an engine, which wait for compilers and are not shown.
 *
 * @param whole what will be drawn
 * @param small the same with few pixels: the JVM compiles the same code for it, and before it has, an engine may be hundreds of
 *     times slower
 */
record WarmUp(FrameInput whole, FrameInput small) {
    /** A JVM engine is warm when a whole picture may be expected in this time, or when its times have settled ... */
    private static final long SWIFT_NANOS = TimeUnit.MILLISECONDS.toNanos(50);

    /** ... or when it has had this much time. */
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(6);

    /**
     * Draws until the engine is about as fast as it will be.
     *
     * @param unwanted whether to stop because the engine will not be used
     */
    void run(Engine engine, BooleanSupplier unwanted) {
        if (Engines.isDevice(engine.id())) {
            // TornadoVM compiles for each size and kind of picture.
            engine.render(whole, Frame.ofPixels(whole.width(), whole.rows()));
        } else {
            runOnJvm(engine, unwanted);
        }
    }

    private void runOnJvm(Engine engine, BooleanSupplier unwanted) {
        SettlingFrames frames = new SettlingFrames(engine, small);
        double ratio = (double) whole.width() * whole.rows() / ((double) small.width() * small.rows());
        long start = System.nanoTime();
        long nanos;
        do {
            nanos = frames.draw().toNanos();
        } while (!frames.areSettled()
                && nanos > SWIFT_NANOS / ratio
                && System.nanoTime() - start < PATIENCE_NANOS
                && !unwanted.getAsBoolean());
    }
}
