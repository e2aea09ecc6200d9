package dev.twister.gui.studio;

import dev.twister.gui.controls.Command;
import dev.twister.gui.edit.KeyframeEdits;
import dev.twister.gui.edit.TrackEdits;
import dev.twister.gui.edit.TrackEdits.KeyMark;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.Animation;
import dev.twister.world.SceneMeshes;
import dev.twister.world.animation.CameraPath;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SequencedMap;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.SimpleBooleanProperty;

/** The film of the scene's keyframes: its present time, at which everything is as they say. */
public final class Film {
    /** Times that differ by less are the same. */
    private static final double EPSILON = 1e-6;

    private final Document document;
    private final BooleanSupplier physics;
    private final Supplier<SceneMeshes> meshes;
    private final Runnable redraw;
    private final Consumer<String> notice;
    private final ReadOnlyDoubleWrapper seconds = new ReadOnlyDoubleWrapper(0);
    private final BooleanProperty shown = new SimpleBooleanProperty(false);
    private final ReadOnlyBooleanWrapper playing = new ReadOnlyBooleanWrapper(false);

    /** The camera when playing started: keyframes may leave out the field of view and the focus. */
    private Camera start;

    /**
     * The film of a document.
     *
     * @param physics whether it is on, which moves spheres whatever their keyframes say
     * @param meshes those of the picture, whose animations have lengths
     * @param redraw draws the scene at the film's time
     */
    Film(
            Document document,
            BooleanSupplier physics,
            Supplier<SceneMeshes> meshes,
            Runnable redraw,
            Consumer<String> notice) {
        this.document = document;
        this.physics = physics;
        this.meshes = meshes;
        this.redraw = redraw;
        this.notice = notice;
        start = document.scene().camera();
        startAnew();
    }

    /** Called for another scene: goes to the start; the film is shown if it has keyframes. */
    void startAnew() {
        playing.set(false);
        seconds.set(0);
        shown.set(Animation.isIn(document.scene()));
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

    /** The time of the last keyframe, or of the end of an animation of a mesh, in seconds. */
    public double length() {
        return Animation.length(document.scene(), meshes.get());
    }

    /** The document's scene as pictures show it: its meshes are as far in their animations as they are now. */
    public Scene played(Scene scene) {
        return Animation.played(scene, seconds.get());
    }

    /**
     * As above, some time before or after the present. What has been edited since the film came to the present rests.
     *
     * @param later in seconds; below 0 for before
     */
    public Scene played(Scene scene, double later) {
        double now = seconds.get();
        Scene pathed = scene.camera().equals(CameraPath.at(scene.camera(), now))
                ? scene.withCamera(CameraPath.at(scene.camera(), now + later))
                : scene;
        Scene moved = keyed(scene, now).equals(scene) ? keyed(pathed, now + later) : pathed;
        return later == 0 ? played(scene) : Animation.played(moved, now + later);
    }

    private Scene keyed(Scene scene, double time) {
        Scene keyed = Animation.keyed(scene, time);
        return physics.getAsBoolean() ? keyed.withSpheres(scene.spheres()) : keyed;
    }

    /** Those of the camera's path. */
    public List<CameraKeyframe> keyframes() {
        return document.scene().camera().keyframes();
    }

    /** The camera's keyframe at the present time. */
    public OptionalInt present() {
        return KeyframeEdits.at(keyframes(), seconds.get());
    }

    /** Seeks to a time and stops playing. Outside of its keyframes' range the camera does not move. */
    public void goTo(double time) {
        playing.set(false);
        seconds.set(KeyframeEdits.time(time));
        List<CameraKeyframe> keys = keyframes();
        if (!keys.isEmpty()
                && seconds.get() >= keys.getFirst().seconds()
                && seconds.get() <= keys.getLast().seconds()) {
            document.followPath(CameraPath.at(document.scene().camera(), seconds.get()));
        }
        follow();
    }

    /** Shows all that has tracks as it is at the present time, which is no edit. */
    void follow() {
        Scene scene = document.scene();
        if (!scene.tracks().isEmpty()) {
            document.follow(keyed(scene, seconds.get()));
        }
        if (Animation.isOfMeshes(scene)) {
            redraw.run();
        }
    }

    /** Goes to a keyframe by its index. */
    public void goToKeyframe(int index) {
        goTo(keyframes().get(index).seconds());
    }

    /** Goes to the next or previous keyframe; tells it if there is none. */
    public void goAlong(boolean forward) {
        List<Double> times = TrackEdits.times(document.scene());
        (forward ? times : times.reversed())
                .stream()
                        .filter(time -> forward ? time > seconds.get() + EPSILON : time < seconds.get() - EPSILON)
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

    /** Sets a keyframe of the camera's path with the present camera at the present time. */
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

    /**
     * Sets keyframes of properties at the present time, as one edit.
     *
     * @param properties of each target, by their names; those that it has not are left out
     */
    public void setKeyframes(SequencedMap<TrackTarget, List<String>> properties) {
        playing.set(false);
        shown.set(true);
        double time = KeyframeEdits.time(seconds.get());
        seconds.set(time);
        document.edit("set keyframes", scene -> {
            Scene now = scene;
            for (Map.Entry<TrackTarget, List<String>> entry : properties.entrySet()) {
                for (String property : entry.getValue()) {
                    now = TrackEdits.set(now, entry.getKey(), property, time);
                }
            }
            return now;
        });
        document.endGesture();
        notice.accept("Keyframe set at " + KeyframeEdits.text(time) + " s; change the time for the next one");
    }

    /** Deletes all keyframes of targets at the present time; tells it if there are none. */
    public void deleteKeyframes(List<TrackTarget> targets) {
        Set<KeyMark> marks = new LinkedHashSet<>();
        targets.forEach(target -> marks.add(new KeyMark(target, seconds.get())));
        if (TrackEdits.deleted(document.scene(), marks).equals(document.scene())) {
            notice.accept("No keyframe of the selection at " + KeyframeEdits.text(seconds.get()) + " s");
        } else {
            edit("delete keyframes", scene -> TrackEdits.deleted(scene, marks));
            document.endGesture();
        }
    }

    /** Edits keyframes, and shows what they make of the present time. */
    public void edit(String what, UnaryOperator<Scene> change) {
        playing.set(false);
        document.edit(what, change);
        follow();
    }

    /** Deletes the camera's keyframe at the present time; tells it if there is none. */
    public void deleteKeyframe() {
        present()
                .ifPresentOrElse(
                        index -> {
                            document.edit("delete keyframe", scene -> KeyframeEdits.deleted(scene, index));
                            document.endGesture();
                        },
                        () -> notice.accept("No keyframe at " + KeyframeEdits.text(seconds.get()) + " s"));
    }

    /** Moves a keyframe of the camera to another time, and goes there. */
    public void moveKeyframe(int index, double time) {
        playing.set(false);
        document.edit("move keyframe", scene -> KeyframeEdits.moved(scene, index, time));
        seconds.set(keyframes().get(index).seconds());
    }

    /** Starts or stops playing. Starts from the present time; at the end, from the first keyframe. */
    public void togglePlaying() {
        List<Double> times = TrackEdits.times(document.scene());
        if (playing.get()) {
            playing.set(false);
        } else if (!canPlay()) {
            notice.accept("Set two keyframes or more to play them");
        } else {
            start = document.scene().camera();
            double first = Animation.isOfMeshes(document.scene()) ? 0 : times.getFirst();
            boolean within = seconds.get() >= first && seconds.get() < length();
            seconds.set(within ? seconds.get() : first);
            playing.set(true);
        }
    }

    private boolean canPlay() {
        Scene scene = document.scene();
        return TrackEdits.times(scene).size() >= 2 || Animation.isOfMeshes(scene);
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
        Scene scene = document.scene();
        double end = length();
        if (!canPlay() || end == 0) {
            // Keyframes were deleted, or the file of a mesh is not read yet.
            playing.set(canPlay() && meshes.get().equals(SceneMeshes.NONE));
            return;
        }
        boolean again = Animation.repeats(scene);
        double now = seconds.get() + passed;
        seconds.set(again && now >= end ? (now - end) % end : Math.min(end, now));
        if (!keyframes().isEmpty()) {
            document.followPath(CameraPath.at(start.withKeyframes(keyframes()), seconds.get()));
        }
        follow();
        if (!again && seconds.get() >= end) {
            playing.set(false);
        }
    }
}
