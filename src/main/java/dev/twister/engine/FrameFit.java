package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.FrameInput;

/** Whether a frame can take what an input describes. */
public final class FrameFit {
    private FrameFit() {}

    /**
     * Does nothing where it can.
     *
     * @throws IllegalArgumentException where the frame's width or height is not that of the input's band
     */
    public static void check(FrameInput input, Frame frame) {
        if (frame.width() != input.width() || frame.height() != input.rows()) {
            throw new IllegalArgumentException("a frame of " + frame.width() + " x " + frame.height() + " for "
                    + input.rows() + " rows of a picture " + input.width() + " wide");
        }
    }
}
