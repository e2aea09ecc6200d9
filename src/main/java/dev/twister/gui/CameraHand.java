package dev.twister.gui;

import dev.twister.scene.Camera;
import dev.twister.world.CameraMotion;
import dev.twister.world.Turn;
import dev.twister.world.Walk;
import java.util.Optional;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.collections.FXCollections;
import javafx.collections.ObservableMap;

/** Moves a studio's camera as long as a person wants it to, and to the views that they kept. */
final class CameraHand {
    private final Studio studio;
    private final ObservableMap<Integer, Camera> views = FXCollections.observableHashMap();
    private final ObjectProperty<Double> speed = new SimpleObjectProperty<>(CameraMotion.WALK_METERS_PER_SECOND);
    private Walk walk = Walk.STILL;
    private Turn turn = Turn.STILL;

    CameraHand(Studio studio) {
        this.studio = studio;
    }

    /** The views kept under a number, from 0 to 9. */
    ObservableMap<Integer, Camera> views() {
        return views;
    }

    /** Meters per second that a walk has, above 0. */
    ObjectProperty<Double> speedProperty() {
        return speed;
    }

    /** Back to where the scene's file has the camera. */
    void goHome() {
        studio.moveCamera(_ -> studio.original().camera());
    }

    /** Keeps the camera as it is now under that number. */
    void keepView(int number) {
        views.put(number, studio.scene().camera());
        studio.notice("View kept under " + number);
    }

    /** Goes to the view kept under that number; says so where there is none. */
    void recallView(int number) {
        Optional.ofNullable(views.get(number))
                .ifPresentOrElse(
                        view -> studio.moveCamera(_ -> view),
                        () -> studio.notice(
                                "No view is kept under " + number + "; Ctrl+" + number + " keeps this one"));
    }

    /** From now on each pulse moves the camera that way, until told otherwise. */
    void setWalk(Walk newWalk) {
        walk = newWalk;
    }

    /** From now on each pulse turns the camera that way, until told otherwise. */
    void setTurn(Turn newTurn) {
        turn = newTurn;
    }

    /** Called in every pulse, with the time since the one before. */
    void pulse(double seconds) {
        studio.moveCamera(camera -> CameraMotion.walk(
                CameraMotion.turn(camera, turn, seconds),
                walk,
                seconds * speed.get() / CameraMotion.WALK_METERS_PER_SECOND,
                studio.scene().plane()));
    }
}
