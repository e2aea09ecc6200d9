package dev.twister.gui.edit;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Easing;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneLimits;
import dev.twister.scene.property.TrackProperties;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.DoublePredicate;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/** Edits of the keyframes of a scene. Their times are multiples of 0.01 s. */
public final class TrackEdits {
    private static final double HALF_A_HUNDREDTH = 0.005;

    private TrackEdits() {}

    /** What moves: the camera, all others in the order of their tracks, then meshes that play an animation. */
    public static List<TrackTarget> targets(Scene scene) {
        Set<TrackTarget> targets = new LinkedHashSet<>();
        if (!scene.camera().keyframes().isEmpty()) {
            targets.add(TrackTarget.CAMERA);
        }
        scene.tracks().forEach(track -> targets.add(track.target()));
        for (int index = 0; index < scene.meshes().size(); index++) {
            if (!scene.meshes().get(index).animation().isNone()) {
                targets.add(TrackTarget.mesh(index));
            }
        }
        return List.copyOf(targets);
    }

    /** The times of a target's keyframes, in their order. */
    public static List<Double> times(Scene scene, TrackTarget target) {
        Stream<Double> path = target.equals(TrackTarget.CAMERA)
                ? scene.camera().keyframes().stream().map(CameraKeyframe::seconds)
                : Stream.empty();
        Stream<Double> tracks =
                of(scene, target).flatMap(track -> track.keyframes().stream()).map(Keyframe::seconds);
        return Stream.concat(path, tracks).distinct().sorted().toList();
    }

    /** The times of all keyframes, in their order. */
    public static List<Double> times(Scene scene) {
        return targets(scene).stream()
                .flatMap(target -> times(scene, target).stream())
                .distinct()
                .sorted()
                .toList();
    }

    /** Whether a keyframe is at a time, as close as times are shown. */
    public static boolean isAt(double keyframe, double seconds) {
        return Math.abs(keyframe - seconds) < HALF_A_HUNDREDTH;
    }

    /** The scene with a keyframe of a property at its present value, which replaces one at the same time. */
    public static Scene set(Scene scene, TrackTarget target, String property, double seconds) {
        Optional<Property<Scene, ?>> animated = TrackProperties.find(target, property);
        if (animated.isEmpty() || target.index() >= target.count(scene)) {
            return scene;
        }
        double time = KeyframeEdits.time(seconds);
        Track old = scene.tracks().stream()
                .filter(track -> track.isOf(target, property))
                .findFirst()
                .orElseGet(() -> Track.of(target, property));
        Easing easing = old.keyframes().stream()
                .filter(keyframe -> keyframe.seconds() <= time + HALF_A_HUNDREDTH)
                .reduce((_, later) -> later)
                .map(Keyframe::easing)
                .orElse(Easing.SMOOTH);
        Keyframe keyframe = new Keyframe(time, animated.get().numbers(scene), easing);
        return with(scene, old.withKeyframes(merged(old.keyframes(), List.of(keyframe), Keyframe::seconds)));
    }

    /** The scene without the keyframes of those marks; what has no keyframe left has no track. */
    public static Scene deleted(Scene scene, Set<KeyMark> marks) {
        return changed(scene, marks, _ -> List.of(), _ -> List.of());
    }

    /** The scene with the keyframes of those marks later by some seconds, but none before the film's beginning. */
    public static Scene moved(Scene scene, Set<KeyMark> marks, double seconds) {
        double shift = Math.max(seconds, -earliest(marks));
        return changed(
                scene,
                marks,
                keyframes -> keyframes.stream()
                        .map(keyframe -> keyframe.withSeconds(KeyframeEdits.time(keyframe.seconds() + shift)))
                        .toList(),
                keyframes -> keyframes.stream()
                        .map(keyframe -> keyframe.withSeconds(KeyframeEdits.time(keyframe.seconds() + shift)))
                        .toList());
    }

    /** The marks after {@link #moved}. */
    public static Set<KeyMark> movedMarks(Set<KeyMark> marks, double seconds) {
        double shift = Math.max(seconds, -earliest(marks));
        Set<KeyMark> moved = new LinkedHashSet<>();
        marks.forEach(mark -> moved.add(new KeyMark(mark.target(), KeyframeEdits.time(mark.seconds() + shift))));
        return moved;
    }

    /** The scene with copies of the keyframes of those marks, the first of them at a time. */
    public static Scene copied(Scene scene, Set<KeyMark> marks, double seconds) {
        double shift = KeyframeEdits.time(seconds) - earliest(marks);
        return changed(
                scene,
                marks,
                keyframes -> keyframes.stream()
                        .flatMap(keyframe -> Stream.of(
                                keyframe, keyframe.withSeconds(KeyframeEdits.time(keyframe.seconds() + shift))))
                        .toList(),
                keyframes -> keyframes.stream()
                        .flatMap(keyframe -> Stream.of(
                                keyframe, keyframe.withSeconds(KeyframeEdits.time(keyframe.seconds() + shift))))
                        .toList());
    }

    /** The scene with another easing after the keyframes of those marks; that of the camera's path stays. */
    public static Scene eased(Scene scene, Set<KeyMark> marks, Easing easing) {
        return changed(
                scene,
                marks,
                keyframes -> keyframes.stream()
                        .map(keyframe -> keyframe.withEasing(easing))
                        .toList(),
                keyframes -> keyframes);
    }

    /** The scene with all tracks of a target looping, or none. */
    public static Scene looped(Scene scene, TrackTarget target, boolean loop) {
        return scene.withTracks(scene.tracks().stream()
                .map(track -> track.target().equals(target) ? track.withLoop(loop) : track)
                .toList());
    }

    /** Whether any track of a target loops. */
    public static boolean isLooped(Scene scene, TrackTarget target) {
        return of(scene, target).anyMatch(Track::loop);
    }

    /** The tracks of a scene whose bodies have other numbers: those of bodies that have none are left out. */
    public static List<Track> renumbered(List<Track> tracks, Function<TrackTarget, Optional<TrackTarget>> numbers) {
        return tracks.stream()
                .flatMap(track -> numbers.apply(track.target()).map(track::withTarget).stream())
                .toList();
    }

    private static double earliest(Set<KeyMark> marks) {
        return marks.stream().mapToDouble(KeyMark::seconds).min().orElse(0);
    }

    private static Scene changed(
            Scene scene,
            Set<KeyMark> marks,
            UnaryOperator<List<Keyframe>> ofTracks,
            UnaryOperator<List<CameraKeyframe>> ofPath) {
        List<Track> tracks = new ArrayList<>();
        for (Track track : scene.tracks()) {
            DoublePredicate marked = seconds -> isMarked(marks, track.target(), seconds);
            List<Keyframe> keyframes = replaced(track.keyframes(), marked, ofTracks, Keyframe::seconds);
            if (!keyframes.isEmpty()) {
                tracks.add(track.withKeyframes(keyframes));
            }
        }
        Camera camera = scene.camera();
        List<CameraKeyframe> path = replaced(
                camera.keyframes(),
                seconds -> isMarked(marks, TrackTarget.CAMERA, seconds),
                ofPath,
                CameraKeyframe::seconds);
        Scene changed = scene.withTracks(tracks);
        return path.equals(camera.keyframes()) ? changed : changed.withCamera(camera.withKeyframes(path));
    }

    private static <K> List<K> replaced(
            List<K> keyframes, DoublePredicate marked, UnaryOperator<List<K>> change, ToDoubleFunction<K> time) {
        List<K> others = keyframes.stream()
                .filter(keyframe -> !marked.test(time.applyAsDouble(keyframe)))
                .toList();
        List<K> chosen = keyframes.stream()
                .filter(keyframe -> marked.test(time.applyAsDouble(keyframe)))
                .toList();
        return chosen.isEmpty() ? keyframes : merged(others, change.apply(chosen), time);
    }

    /** In the order of their times; the newer ones replace older ones at the same time. */
    private static <K> List<K> merged(Collection<K> older, Collection<K> newer, ToDoubleFunction<K> time) {
        Map<Double, K> byTime = new TreeMap<>();
        older.forEach(keyframe -> byTime.put(time.applyAsDouble(keyframe), keyframe));
        for (K keyframe : newer) {
            byTime.keySet().removeIf(other -> isAt(other, time.applyAsDouble(keyframe)));
            byTime.put(time.applyAsDouble(keyframe), keyframe);
        }
        return List.copyOf(byTime.values()).subList(0, Math.min(byTime.size(), SceneLimits.MAX_KEYFRAMES));
    }

    private static boolean isMarked(Set<KeyMark> marks, TrackTarget target, double seconds) {
        return marks.stream().anyMatch(mark -> mark.target().equals(target) && isAt(mark.seconds(), seconds));
    }

    private static Stream<Track> of(Scene scene, TrackTarget target) {
        return scene.tracks().stream().filter(track -> track.target().equals(target));
    }

    private static Scene with(Scene scene, Track changed) {
        List<Track> tracks = new ArrayList<>(scene.tracks());
        int index = -1;
        for (int i = 0; i < tracks.size(); i++) {
            index = tracks.get(i).isOf(changed.target(), changed.property()) ? i : index;
        }
        if (index >= 0) {
            tracks.set(index, changed);
        } else if (tracks.size() < SceneLimits.MAX_TRACKS) {
            tracks.add(changed);
        }
        return scene.withTracks(tracks);
    }

    /** All keyframes of one part of a scene at one time; of the camera, also those of its path. */
    public record KeyMark(TrackTarget target, double seconds) {}
}
