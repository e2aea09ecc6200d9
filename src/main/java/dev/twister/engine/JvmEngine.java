package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;

/**
 * An engine of the JVM: the kernel's own code, called by plain Java; they differ in who draws which row.
 *
 * @param rows draws all rows of a frame
 */
record JvmEngine(String id, String device, Rows rows) implements Engine {
    /** How the rows of a frame are gone through. */
    @FunctionalInterface
    interface Rows {
        void draw(FrameInput input, Frame frame);
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        FrameFit.check(input, frame);
        long start = System.nanoTime();
        rows.draw(input, frame);
        frame.setTimes(FrameTimes.onJvm(System.nanoTime() - start));
    }

    @Override
    public boolean drawsBandsInProportion() {
        return true;
    }

    @Override
    public void close() {
        // The JVM's engines hold nothing between frames.
    }
}
