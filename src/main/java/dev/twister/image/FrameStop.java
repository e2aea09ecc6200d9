package dev.twister.image;

/**
 * When a frame must be stopped: the thread that asked for it is interrupted, or the frame says so. Used from several
 * threads. The interrupt is not cleared.
 */
public final class FrameStop {
    private final Thread caller = Thread.currentThread();
    private final Frame frame;
    private volatile boolean asked;

    private FrameStop(Frame frame) {
        this.frame = frame;
    }

    /** Of a frame that this thread asks for. */
    public static FrameStop of(Frame frame) {
        return new FrameStop(frame);
    }

    /** The frame that is rendered. */
    public Frame frame() {
        return frame;
    }

    /** Asks to stop: for a caller that waits, and whose interrupt is cleared while it does. */
    public void ask() {
        asked = true;
    }

    public boolean isAsked() {
        return asked || caller.isInterrupted() || frame.isToStop();
    }

    /**
     * Called before and after rendering.
     *
     * @throws RenderStoppedException if the frame must be stopped
     */
    public void check() {
        if (isAsked()) {
            throw new RenderStoppedException();
        }
    }
}
