package dev.twister.gui.studio;

import dev.twister.gui.edit.ViewEdits;
import dev.twister.scene.CameraView;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.animation.CameraMotion;
import dev.twister.world.animation.Turn;
import dev.twister.world.animation.Walk;
import java.util.List;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;

/** Walks and turns the camera while keys are held, and keeps and recalls views. */
public final class CameraControl {
    public static final String FULL = "The scene has " + SceneLimits.MAX_VIEWS + " views, and can't have more";

    private final Document document;
    private final Consumer<String> notice;
    private final ObjectProperty<Double> speed = new SimpleObjectProperty<>(CameraMotion.WALK_METERS_PER_SECOND);
    private Walk walk = Walk.STILL;
    private Turn turn = Turn.STILL;

    CameraControl(Document document, Consumer<String> notice) {
        this.document = document;
        this.notice = notice;
    }

    /** Walking speed in meters per second, above 0. */
    public ObjectProperty<Double> speedProperty() {
        return speed;
    }

    /** Whether keys that walk or turn are held. */
    boolean isMoving() {
        return !walk.equals(Walk.STILL) || !turn.equals(Turn.STILL);
    }

    /** Moves the camera to its place in the scene's file. */
    public void goHome() {
        document.moveCamera(_ -> document.original().camera());
    }

    /** Keeps the present camera as the view of a number key, or as a new view after the last. */
    public void keepView(int digit) {
        int index = ViewEdits.ofKey(digit);
        boolean there = index < document.scene().views().size();
        if (!there && ViewEdits.isFull(document.scene())) {
            notice.accept(FULL);
            return;
        }
        document.endGesture();
        document.edit(
                there ? "update view" : "add view",
                scene -> there
                        ? ViewEdits.updated(scene, index, scene.camera())
                        : ViewEdits.added(scene, scene.camera()));
        document.endGesture();
        List<CameraView> views = document.scene().views();
        int kept = there ? index : views.size() - 1;
        notice.accept("View kept"
                + ViewEdits.key(kept).map(key -> " under " + key).orElse("") + ": "
                + views.get(kept).name());
    }

    /** Goes to the view of a number key; tells it if there is none. */
    public void recallView(int digit) {
        int index = ViewEdits.ofKey(digit);
        List<CameraView> views = document.scene().views();
        if (index < views.size()) {
            goTo(views.get(index));
        } else {
            notice.accept("No view is kept under " + digit + "; Ctrl+" + digit + " keeps this one");
        }
    }

    public void goTo(CameraView view) {
        document.goTo(view.camera());
        notice.accept("View: " + view.name());
    }

    /** Sets how each pulse moves the camera. */
    public void setWalk(Walk newWalk) {
        walk = newWalk;
    }

    /** Sets how each pulse turns the camera. */
    public void setTurn(Turn newTurn) {
        turn = newTurn;
    }

    /**
     * Called in every pulse.
     *
     * @param seconds since the last one
     */
    void pulse(double seconds) {
        document.moveCamera(camera -> CameraMotion.walk(
                CameraMotion.turn(camera, turn, seconds),
                walk,
                seconds * speed.get() / CameraMotion.WALK_METERS_PER_SECOND,
                document.scene().ground()));
    }
}
