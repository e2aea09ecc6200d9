package dev.twister.gui.studio;

import dev.twister.gui.model.ViewEdits;
import dev.twister.scene.CameraView;
import dev.twister.scene.SceneLimits;
import dev.twister.world.CameraMotion;
import dev.twister.world.Turn;
import dev.twister.world.Walk;
import java.util.List;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;

/** Moves a studio's camera as long as a person wants it to, and to the views that the scene keeps. */
public final class CameraHand {
    public static final String FULL = "The scene has " + SceneLimits.MAX_VIEWS + " views, and can't have more";

    private final Document document;
    private final Consumer<String> notice;
    private final ObjectProperty<Double> speed = new SimpleObjectProperty<>(CameraMotion.WALK_METERS_PER_SECOND);
    private Walk walk = Walk.STILL;
    private Turn turn = Turn.STILL;

    CameraHand(Document document, Consumer<String> notice) {
        this.document = document;
        this.notice = notice;
    }

    /** Meters per second that a walk has, above 0. */
    public ObjectProperty<Double> speedProperty() {
        return speed;
    }

    /** Back to where the scene's file has the camera. */
    public void goHome() {
        document.moveCamera(_ -> document.original().camera());
    }

    /** Keeps the camera as it is now as the view that a number key leads to, or as another one behind the last. */
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

    /** Goes to the view that a number key leads to; says so where there is none. */
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
        document.moveCamera(camera -> CameraMotion.walk(
                CameraMotion.turn(camera, turn, seconds),
                walk,
                seconds * speed.get() / CameraMotion.WALK_METERS_PER_SECOND,
                document.scene().ground()));
    }
}
