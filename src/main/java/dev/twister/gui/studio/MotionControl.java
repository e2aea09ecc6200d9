package dev.twister.gui.studio;

import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyNumber;
import java.util.function.Consumer;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** Starts, pauses and stops physics. */
public final class MotionControl {
    private final Document document;
    private final Selection selection;
    private final Consumer<String> notice;
    private final Runnable request;
    private final ReadOnlyObjectWrapper<Motion> motion = new ReadOnlyObjectWrapper<>(Motion.NONE);
    private long starts;

    /**
     * A motion that is off.
     *
     * @param request requests a picture after each change
     */
    MotionControl(Document document, Selection selection, Consumer<String> notice, Runnable request) {
        this.document = document;
        this.selection = selection;
        this.notice = notice;
        this.request = request;
    }

    /** Whether and how bodies move. */
    public ReadOnlyObjectProperty<Motion> motionProperty() {
        return motion.getReadOnlyProperty();
    }

    /** Whether physics is on, paused or not. */
    public boolean isOn() {
        return motion.get().isOn();
    }

    /** Starts physics, or stops it, which returns the bodies to their places in the scene. */
    public void setOn(boolean on) {
        starts++;
        boolean moved = isOn();
        set(on ? new Motion(starts, true, 0) : Motion.NONE);
        if (on) {
            notice.accept(StatusText.whatFalls(document.scene()));
        } else if (moved) {
            notice.accept("Physics off: bodies are where the scene has them");
        }
    }

    /** Pauses or resumes physics; starts it if it is off. */
    public void togglePause() {
        Motion now = motion.get();
        if (now.isOn()) {
            set(new Motion(now.start(), !now.running(), now.steps()));
            notice.accept(now.running() ? "Paused" : "Resumed");
        } else {
            setOn(true);
        }
    }

    /** Simulates one step, then pauses. */
    public void stepOnce() {
        if (!isOn()) {
            setOn(true);
        }
        Motion now = motion.get();
        set(new Motion(now.start(), false, now.steps() + 1));
    }

    /** Stops physics before another scene is shown. */
    void reset() {
        motion.set(Motion.NONE);
    }

    private void set(Motion next) {
        if (next.start() != motion.get().start() && BodyEdits.isPoured(document.scene(), selection.active())) {
            selection.select(BodyNumber.NONE);
        }
        motion.set(next);
        request.run();
    }
}
