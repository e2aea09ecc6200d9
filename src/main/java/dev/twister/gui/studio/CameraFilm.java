package dev.twister.gui.studio;

import dev.twister.gui.controls.Command;
import dev.twister.gui.model.KeyframeEdits;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.SceneLimits;
import dev.twister.world.CameraPath;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Consumer;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.SimpleBooleanProperty;

/** A time in the film that the camera's keyframes make; the camera follows it along their path. */
public final class CameraFilm {
    private final Document document;
    private final Consumer<String> notice;
    private final ReadOnlyDoubleWrapper seconds = new ReadOnlyDoubleWrapper(0);
    private final BooleanProperty shown = new SimpleBooleanProperty(false);
    private final ReadOnlyBooleanWrapper playing = new ReadOnlyBooleanWrapper(false);

    /** As it was when the film began to play: keyframes may leave its field of view and its focus as they are. */
    private Camera start;

    CameraFilm(Document document, Consumer<String> notice) {
        this.document = document;
        this.notice = notice;
        start = document.scene().camera();
        startAnew();
    }

    /** Another scene is shown: its film begins, and is in sight where there is one. */
    void startAnew() {
        playing.set(false);
        seconds.set(0);
        shown.set(!keyframes().isEmpty());
    }

    /** Whether the keyframes are in sight. */
    public BooleanProperty shownProperty() {
        return shown;
    }

    /** Seconds since the film's beginning. */
    public ReadOnlyDoubleProperty secondsProperty() {
        return seconds.getReadOnlyProperty();
    }

    public ReadOnlyBooleanProperty playingProperty() {
        return playing.getReadOnlyProperty();
    }

    public List<CameraKeyframe> keyframes() {
        return document.scene().camera().keyframes();
    }

    /** The keyframe at the present time. */
    public OptionalInt present() {
        return KeyframeEdits.at(keyframes(), seconds.get());
    }

    /** Goes to a time, and ends a film that plays. Before the first keyframe and after the last, the camera stays. */
    public void goTo(double time) {
        playing.set(false);
        seconds.set(KeyframeEdits.time(time));
        List<CameraKeyframe> keys = keyframes();
        if (!keys.isEmpty()
                && seconds.get() >= keys.getFirst().seconds()
                && seconds.get() <= keys.getLast().seconds()) {
            document.followPath(CameraPath.at(document.scene().camera(), seconds.get()));
        }
    }

    /** Goes to a keyframe, by its place in their list. */
    public void goToKeyframe(int index) {
        goTo(keyframes().get(index).seconds());
    }

    /** Goes to the next keyframe, or to the one before; says so where there is none. */
    public void goAlong(boolean forward) {
        List<Double> times = keyframes().stream().map(CameraKeyframe::seconds).toList();
        (forward ? times : times.reversed())
                .stream()
                        .filter(time -> forward ? time > seconds.get() : time < seconds.get())
                        .findFirst()
                        .ifPresentOrElse(
                                this::goTo,
                                () -> notice.accept(
                                        times.isEmpty()
                                                ? "No keyframes: "
                                                        + Command.SET_KEYFRAME
                                                                .keys()
                                                                .getDisplayText() + " sets one"
                                                : forward ? "No later keyframe" : "No earlier keyframe"));
    }

    /** Makes the camera as it is now a keyframe of the present time. */
    public void setKeyframe() {
        if (keyframes().size() >= SceneLimits.MAX_KEYFRAMES && present().isEmpty()) {
            notice.accept("A camera has at most " + SceneLimits.MAX_KEYFRAMES + " keyframes");
            return;
        }
        playing.set(false);
        shown.set(true);
        double time = KeyframeEdits.time(seconds.get());
        seconds.set(time);
        document.edit("set keyframe", scene -> KeyframeEdits.set(scene, time));
        document.endGesture();
        notice.accept("Keyframe set at " + KeyframeEdits.text(time) + " s; change the time for the next one");
    }

    /** Deletes the keyframe of the present time; says so where there is none. */
    public void deleteKeyframe() {
        present()
                .ifPresentOrElse(
                        index -> {
                            document.edit("delete keyframe", scene -> KeyframeEdits.deleted(scene, index));
                            document.endGesture();
                        },
                        () -> notice.accept("No keyframe at " + KeyframeEdits.text(seconds.get()) + " s"));
    }

    /** Moves a keyframe to another time, and goes along with it. */
    public void moveKeyframe(int index, double time) {
        playing.set(false);
        document.edit("move keyframe", scene -> KeyframeEdits.moved(scene, index, time));
        seconds.set(keyframes().get(index).seconds());
    }

    /** Plays from the present time, from the first keyframe where that is the end; or stops. */
    public void togglePlaying() {
        List<CameraKeyframe> keys = keyframes();
        if (playing.get()) {
            playing.set(false);
        } else if (keys.size() < 2) {
            notice.accept("Set two keyframes or more to play the camera's path");
        } else {
            start = document.scene().camera();
            boolean within = seconds.get() >= keys.getFirst().seconds()
                    && seconds.get() < keys.getLast().seconds();
            seconds.set(within ? seconds.get() : keys.getFirst().seconds());
            playing.set(true);
        }
    }

    /** Called in every pulse, with the time since the one before. */
    void pulse(double passed) {
        if (!playing.get()) {
            return;
        }
        if (keyframes().size() < 2) {
            // They were deleted, or undone.
            playing.set(false);
            return;
        }
        double end = keyframes().getLast().seconds();
        seconds.set(Math.min(end, seconds.get() + passed));
        document.followPath(CameraPath.at(start.withKeyframes(keyframes()), seconds.get()));
        if (seconds.get() >= end) {
            playing.set(false);
        }
    }
}
