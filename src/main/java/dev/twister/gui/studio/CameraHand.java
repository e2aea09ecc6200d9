package dev.twister.gui.studio;

import dev.twister.gui.model.ViewEdits;
import dev.twister.scene.CameraView;
import dev.twister.scene.SceneLimits;
import dev.twister.world.CameraMotion;
import dev.twister.world.Turn;
import dev.twister.world.Walk;
import java.util.List;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;

/** Moves a studio's camera as long as a person wants it to, and to the views that the scene keeps. */
public final class CameraHand {
    public static final String FULL = "The scene has " + SceneLimits.MAX_VIEWS + " views, and can't have more";

    private final Studio studio;
    private final ObjectProperty<Double> speed = new SimpleObjectProperty<>(CameraMotion.WALK_METERS_PER_SECOND);
    private Walk walk = Walk.STILL;
    private Turn turn = Turn.STILL;

    CameraHand(Studio studio) {
        this.studio = studio;
    }

    /** Meters per second that a walk has, above 0. */
    public ObjectProperty<Double> speedProperty() {
        return speed;
    }

    /** Back to where the scene's file has the camera. */
    public void goHome() {
        studio.moveCamera(_ -> studio.original().camera());
    }

    /** Keeps the camera as it is now as the view that a number key leads to, or as another one behind the last. */
    public void keepView(int digit) {
        int index = ViewEdits.ofKey(digit);
        boolean there = index < studio.scene().views().size();
        if (!there && ViewEdits.isFull(studio.scene())) {
            studio.notice(FULL);
            return;
        }
        studio.endGesture();
        studio.edit(
                there ? "update view" : "add view",
                scene -> there
                        ? ViewEdits.updated(scene, index, scene.camera())
                        : ViewEdits.added(scene, scene.camera()));
        studio.endGesture();
        List<CameraView> views = studio.scene().views();
        int kept = there ? index : views.size() - 1;
        studio.notice("View kept"
                + ViewEdits.key(kept).map(key -> " under " + key).orElse("") + ": "
                + views.get(kept).name());
    }

    /** Goes to the view that a number key leads to; says so where there is none. */
    public void recallView(int digit) {
        int index = ViewEdits.ofKey(digit);
        List<CameraView> views = studio.scene().views();
        if (index < views.size()) {
            goTo(views.get(index));
        } else {
            studio.notice("No view is kept under " + digit + "; Ctrl+" + digit + " keeps this one");
        }
    }

    public void goTo(CameraView view) {
        studio.goTo(view.camera());
        studio.notice("View: " + view.name());
    }

    /** From now on each pulse moves the camera that way, until told otherwise. */
    public void setWalk(Walk newWalk) {
        walk = newWalk;
    }

    /** From now on each pulse turns the camera that way, until told otherwise. */
    public void setTurn(Turn newTurn) {
        turn = newTurn;
    }

    /** Called in every pulse, with the time since the one before. */
    void pulse(double seconds) {
        studio.moveCamera(camera -> CameraMotion.walk(
                CameraMotion.turn(camera, turn, seconds),
                walk,
                seconds * speed.get() / CameraMotion.WALK_METERS_PER_SECOND,
                studio.scene().ground()));
    }
}
