package dev.twister.gui.studio;

import dev.twister.gui.drawing.Motion;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyNumber;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** Starts, pauses and ends the motion of a studio's bodies. */
public final class MotionControl {
    private final Studio studio;
    private final ReadOnlyObjectWrapper<Motion> motion = new ReadOnlyObjectWrapper<>(Motion.NONE);
    private long starts;

    MotionControl(Studio studio) {
        this.studio = studio;
    }

    /** Whether and how bodies move. */
    public ReadOnlyObjectProperty<Motion> motionProperty() {
        return motion.getReadOnlyProperty();
    }

    /** Whether bodies are not where the scene has them: they move, or the motion is paused. */
    public boolean isOn() {
        return motion.get().isOn();
    }

    /** Starts the motion from where the scene has the bodies, or puts them back there. */
    public void setOn(boolean on) {
        starts++;
        boolean moved = isOn();
        set(on ? new Motion(starts, true, 0) : Motion.NONE);
        if (on) {
            studio.notice(StatusText.whatFalls(studio.scene()));
        } else if (moved) {
            studio.notice("Physics off: bodies are where the scene has them");
        }
    }

    /** Pauses the motion or resumes it; starts it where there is none. */
    public void togglePause() {
        Motion now = motion.get();
        if (now.isOn()) {
            set(new Motion(now.start(), !now.running(), now.steps()));
            studio.notice(now.running() ? "Paused" : "Resumed");
        } else {
            setOn(true);
        }
    }

    /** Simulates one step of the physics, then pauses. */
    public void stepOnce() {
        if (!isOn()) {
            setOn(true);
        }
        Motion now = motion.get();
        set(new Motion(now.start(), false, now.steps() + 1));
    }

    /** Ends the motion before another scene is shown. */
    void reset() {
        motion.set(Motion.NONE);
    }

    private void set(Motion next) {
        if (next.start() != motion.get().start()
                && BodyEdits.isPoured(studio.scene(), studio.selection().active())) {
            studio.selection().select(BodyNumber.NONE);
        }
        motion.set(next);
        studio.request();
    }
}
