package dev.twister.gui.drawing;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.SettlingFrames;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/**
 * The first frames of an engine, during which it is compiled; they are not shown.
 *
 * @param whole what will be drawn
 * @param small the same with few pixels: it makes the JVM compile the same code, before which an engine may be hundreds
 *     of times slower
 * @param clock in nanoseconds, as {@link System#nanoTime}
 */
record WarmUp(FrameInput whole, FrameInput small, LongSupplier clock) {
    /** A JVM engine is warm when a whole picture is expected to take this time, when its times have settled ... */
    private static final long SWIFT_NANOS = TimeUnit.MILLISECONDS.toNanos(50);

    /** ... or after this time. */
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(6);

    /** Time of the first small picture with many spheres. */
    private static final int BANDS = 16;

    /**
     * Draws until the engine has reached its speed.
     *
     * @param unwanted whether to stop because the engine will not be used
     */
    void run(Engine engine, BooleanSupplier unwanted) {
        if (Engines.isDevice(engine.id())) {
            // TornadoVM compiles a kernel for pixels, and another for the radiance of a picture at rest.
            engine.render(whole, Frame.ofPixels(whole.width(), whole.rows()));
            if (!unwanted.getAsBoolean()) {
                engine.render(small, Frame.ofRadiance(small.width(), small.rows()));
            }
        } else {
            runOnJvm(engine, unwanted);
        }
    }

    private void runOnJvm(Engine engine, BooleanSupplier unwanted) {
        long start = clock.getAsLong();
        if (engine.drawsBandsInProportion()
                && !small.hasFewSpheres()
                && !drawInBands(engine, () -> unwanted.getAsBoolean() || clock.getAsLong() - start > PATIENCE_NANOS)) {
            return;
        }
        SettlingFrames frames = new SettlingFrames(engine, small);
        double ratio = (double) whole.width() * whole.rows() / ((double) small.width() * small.rows());
        long nanos;
        do {
            nanos = frames.draw().toNanos();
        } while (!frames.areSettled()
                && nanos > SWIFT_NANOS / ratio
                && clock.getAsLong() - start < PATIENCE_NANOS
                && !unwanted.getAsBoolean());
    }

    /**
     * Draws the small picture once, in bands: with thousands of bodies a cold JVM takes many seconds for it.
     *
     * @param leave whether to stop; called between bands
     * @return whether all of it was drawn
     */
    private boolean drawInBands(Engine engine, BooleanSupplier leave) {
        int most = Math.max(1, small.rows() / BANDS);
        int drawn = 0;
        while (drawn < small.rows() && !leave.getAsBoolean()) {
            int rows = Math.min(most, small.rows() - drawn);
            engine.render(small.band(drawn, rows), Frame.ofPixels(small.width(), rows));
            drawn += rows;
        }
        return drawn == small.rows();
    }
}
