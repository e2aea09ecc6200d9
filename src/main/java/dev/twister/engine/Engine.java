package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.image.RenderStoppedException;
import dev.twister.world.FrameInput;

/**
 * Renders frames, either with the kernel or with its own implementation of the kernel's equations, which tests compare
 * with the kernel. Only one thread at a time may use an engine. It keeps its resources (threads, device buffers,
 * compiled kernels) between frames, until it is closed.
 */
public interface Engine extends AutoCloseable {
    /** The name for commands, such as {@code sequential} or {@code tornado:0:0}. */
    String id();

    /** The processor's or device's name, for display. */
    String device();

    /**
     * Renders the rows {@code [input.firstRow(), input.firstRow() + frame.height())} of the picture into {@code frame},
     * and stores the times there.
     *
     * @throws EngineException if the engine or its device fails; the frame's content is then undefined
     * @throws IllegalArgumentException if the frame's width or height does not match the input
     * @throws RenderStoppedException if the thread is interrupted or the frame is stopped, within 0.2 s on the JVM, and
     *     after the device's work elsewhere; the frame then holds what was complete
     * @throws IllegalStateException if the engine is from {@link Engines#open} and was closed
     */
    void render(FrameInput input, Frame frame);

    /**
     * Sets a listener that is called once the next frame would be rendered by a faster engine, so that a picture at
     * rest can be rendered again. Most engines never call it.
     *
     * @param listener called on another thread, possibly during a frame; must return at once
     */
    default void onFaster(Runnable listener) {}

    /**
     * Whether the time for a band is proportional to its rows, so that a slow picture can be rendered in bands. False
     * if each call costs much besides, or while the engine measures frames.
     */
    default boolean drawsBandsInProportion() {
        return false;
    }

    /**
     * Whether this engine would leave the whole frame to the kernel on the JVM's threads, and so is not faster than
     * {@code parallel} there. Costs little; nothing is rendered.
     */
    default boolean declines(FrameInput input) {
        return false;
    }

    /**
     * Signals that no frame is requested for now. Until the next frame the engine may prepare for other scenes on its
     * own threads. Returns at once.
     */
    default void rest() {}

    /** Releases all resources; never throws. */
    @Override
    void close();
}
