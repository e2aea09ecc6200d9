package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.FrameInput;

/** Checks that a frame matches its input. */
public final class FrameFit {
    private FrameFit() {}

    /**
     * Checks the frame's size.
     *
     * @throws IllegalArgumentException if the frame's width or height differs from the input's width or rows
     */
    public static void check(FrameInput input, Frame frame) {
        if (frame.width() != input.width() || frame.height() != input.rows()) {
            throw new IllegalArgumentException("a frame of " + frame.width() + " x " + frame.height() + " for "
                    + input.rows() + " rows of a picture " + input.width() + " wide");
        }
    }
}
