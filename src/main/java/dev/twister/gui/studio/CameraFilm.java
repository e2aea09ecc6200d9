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

/** The film of the camera's keyframes: its present time, at which the camera is on their path. */
public final class CameraFilm {
    private final Document document;
    private final Consumer<String> notice;
    private final ReadOnlyDoubleWrapper seconds = new ReadOnlyDoubleWrapper(0);
    private final BooleanProperty shown = new SimpleBooleanProperty(false);
    private final ReadOnlyBooleanWrapper playing = new ReadOnlyBooleanWrapper(false);

    /** The camera when playing started: keyframes may leave out the field of view and the focus. */
    private Camera start;

    CameraFilm(Document document, Consumer<String> notice) {
        this.document = document;
        this.notice = notice;
        start = document.scene().camera();
        startAnew();
    }

    /** Called for another scene: goes to the start; the film is shown if it has keyframes. */
    void startAnew() {
        playing.set(false);
        seconds.set(0);
        shown.set(!keyframes().isEmpty());
    }

    /** Whether the film bar is shown. */
    public BooleanProperty shownProperty() {
        return shown;
    }

    /** Seconds since the start of the film. */
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

    /** Seeks to a time and stops playing. Outside of the keyframes' range the camera does not move. */
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

    /** Goes to a keyframe by its index. */
    public void goToKeyframe(int index) {
        goTo(keyframes().get(index).seconds());
    }

    /** Goes to the next or previous keyframe; tells it if there is none. */
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

    /** Sets a keyframe with the present camera at the present time. */
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

    /** Deletes the keyframe at the present time; tells it if there is none. */
    public void deleteKeyframe() {
        present()
                .ifPresentOrElse(
                        index -> {
                            document.edit("delete keyframe", scene -> KeyframeEdits.deleted(scene, index));
                            document.endGesture();
                        },
                        () -> notice.accept("No keyframe at " + KeyframeEdits.text(seconds.get()) + " s"));
    }

    /** Moves a keyframe to another time, and goes there. */
    public void moveKeyframe(int index, double time) {
        playing.set(false);
        document.edit("move keyframe", scene -> KeyframeEdits.moved(scene, index, time));
        seconds.set(keyframes().get(index).seconds());
    }

    /** Starts or stops playing. Starts from the present time; at the end, from the first keyframe. */
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

    /**
     * Called in every pulse.
     *
     * @param passed seconds since the last one
     */
    void pulse(double passed) {
        if (!playing.get()) {
            return;
        }
        if (keyframes().size() < 2) {
            // Keyframes were deleted.
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
