package dev.twister.gui.drawing;

import dev.twister.image.Frame;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * Hands pictures from the thread that draws to the thread that shows; neither waits. Four frames are in use: one is
 * drawn, one is finished, one is shown, and one was shown until the last pulse and may still be on its way to the
 * graphics card.
 */
public final class PictureExchange {
    private final Deque<Frame> free = new ArrayDeque<>();
    private Optional<DrawnPicture> newest = Optional.empty();
    private Optional<DrawnPicture> shown = Optional.empty();
    private Optional<DrawnPicture> replaced = Optional.empty();

    /** A free frame of that size; it belongs to the drawing thread until {@link #finished}. */
    public synchronized Frame frameToDraw(int width, int height) {
        free.removeIf(frame -> frame.width() != width || frame.height() != height);
        return free.isEmpty() ? Frame.ofPixels(width, height) : free.pop();
    }

    /** Returns a frame that was not finished. */
    public synchronized void abandon(Frame frame) {
        free.push(frame);
    }

    /** Publishes a finished picture; replaces the previous one if it was not taken. */
    public synchronized void finished(DrawnPicture picture) {
        newest.ifPresent(untaken -> free.push(untaken.frame()));
        newest = Optional.of(picture);
    }

    /**
     * Called once per pulse by the thread that shows: the newest finished picture that was not taken before. Its frame
     * is not drawn over until the pulse after its successor is taken. A picture that repeats the last taken one has the
     * same frame; any other picture has another.
     */
    public synchronized Optional<DrawnPicture> takeNewest() {
        replaced.ifPresent(picture -> free.push(picture.frame()));
        replaced = Optional.empty();
        Optional<DrawnPicture> taken = newest;
        newest = Optional.empty();
        Optional<DrawnPicture> onScreen =
                shown.filter(old -> taken.filter(repetition -> repetition.original() == old.original())
                        .isPresent());
        if (onScreen.isPresent()) {
            taken.ifPresent(repetition -> free.push(repetition.frame()));
            shown = taken.map(repetition -> repetition.in(onScreen.get().frame()));
            return shown;
        }
        if (taken.isPresent()) {
            replaced = shown;
            shown = taken;
        }
        return taken;
    }
}
