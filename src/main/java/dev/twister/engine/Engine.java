package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.FrameInput;

/**
 * Draws frames: with the kernel, or with equations of its own that tests hold to the kernel's pictures. An engine is
 * used by one thread at a time, and holds whatever it needs between frames (threads, device buffers, compiled kernels)
 * until it is closed.
 */
public interface Engine extends AutoCloseable {
    /** The name that commands take, such as {@code sequential} or {@code tornado:0:0}. */
    String id();

    /** What does the work, for a person: a processor's or a device's name. */
    String device();

    /**
     * Draws the rows {@code [input.firstRow(), input.firstRow() + frame.height())} of the picture into all of
     * {@code frame}, and notes the times in it.
     *
     * @throws EngineException where the engine or its device fails; the frame's content is then undefined
     * @throws IllegalArgumentException where the frame's width or rows do not fit the input
     */
    void render(FrameInput input, Frame frame);

    /**
     * Has someone told when the next frame would be drawn by another, faster engine, so that a picture that rests can
     * be drawn by that one; most engines never change.
     *
     * @param listener called on another thread, perhaps while a frame is drawn; must return at once
     */
    default void onFaster(Runnable listener) {}

    /**
     * Whether a band of a picture's rows takes about that part of the picture's time, so that a slow picture may be
     * drawn band by band. Not so where each number of rows is compiled for, or a frame is measured.
     */
    default boolean drawsBandsInProportion() {
        return false;
    }

    /**
     * Says that no frame is wanted for now: what other scenes would have to wait for may be made ready meanwhile, on
     * threads of the engine's own, until the next frame is drawn. Returns at once.
     */
    default void rest() {}

    /** Gives back what the engine holds; never throws. */
    @Override
    void close();
}
