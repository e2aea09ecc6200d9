package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.FrameInput;

/** Checks that a frame matches its input. */
public final class FrameFit {
    private FrameFit() {}

    /**
     * Checks the frame's size and layers.
     *
     * @throws IllegalArgumentException if the frame's width or height differs from the input's width or rows, or if it
     *     has another number of layers
     */
    public static void check(FrameInput input, Frame frame) {
        if (frame.width() != input.width() || frame.height() != input.rows()) {
            throw new IllegalArgumentException("a frame of " + frame.width() + " x " + frame.height() + " for "
                    + input.rows() + " rows of a picture " + input.width() + " wide");
        }
        if (frame.layerCount() != input.layers()) {
            throw new IllegalArgumentException(
                    "a frame of " + frame.layerCount() + " layers for a picture of " + input.layers());
        }
    }
}
