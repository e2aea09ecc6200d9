package dev.twister.gui.drawing;

import dev.twister.image.Frame;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * Where pictures change hands: one thread draws into frames, another shows the newest finished one, and neither waits
 * for the other. Four frames go round: one is drawn, one is finished, one is shown, and one was shown until the last
 * pulse and may still be on its way to the graphics card.
 */
public final class PictureExchange {
    private final Deque<Frame> free = new ArrayDeque<>();
    private Optional<DrawnPicture> newest = Optional.empty();
    private Optional<DrawnPicture> shown = Optional.empty();
    private Optional<DrawnPicture> replaced = Optional.empty();

    /** A frame of that size that no one reads; the drawing thread's until it is {@link #finished}. */
    public synchronized Frame frameToDraw(int width, int height) {
        free.removeIf(frame -> frame.width() != width || frame.height() != height);
        return free.isEmpty() ? Frame.ofPixels(width, height) : free.pop();
    }

    /** Gives back a frame that was not finished. */
    public synchronized void abandon(Frame frame) {
        free.push(frame);
    }

    /** Hands a finished picture over; the one before it is drawn over if no one took it. */
    public synchronized void finished(DrawnPicture picture) {
        newest.ifPresent(untaken -> free.push(untaken.frame()));
        newest = Optional.of(picture);
    }

    /**
     * Called once in every pulse by the thread that shows: the newest finished picture, where there is one that has not
     * been taken. It is not drawn over until the pulse after the one that takes its successor. One that repeats the
     * picture taken before comes in that one's frame, which is on the screen already; no other picture comes in the
     * frame of the one before.
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
