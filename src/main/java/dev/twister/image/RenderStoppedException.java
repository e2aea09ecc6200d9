package dev.twister.image;

/**
 * A frame that was stopped before it was complete: the thread that rendered it was interrupted, or the frame's own
 * condition, {@link Frame#stopWhen}, asked for it. The frame holds the pixels that were complete.
 */
public final class RenderStoppedException extends RuntimeException {
    private static final long serialVersionUID = 1;

    RenderStoppedException() {
        super("the rendering was stopped");
    }
}
