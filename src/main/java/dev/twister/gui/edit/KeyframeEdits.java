package dev.twister.gui.edit;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.SceneLimits;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/** Edits of the keyframes of a scene's camera. Their times are whole hundredths of a second. */
public final class KeyframeEdits {
    private static final double HUNDREDTHS = 100;
    private static final double FULL_TURN_DEGREES = 360;

    private KeyframeEdits() {}

    /** The nearest time that a keyframe may have, in seconds. */
    public static double time(double seconds) {
        return SceneLimits.KEYFRAME_TIME.clamp(Math.rint(seconds * HUNDREDTHS) / HUNDREDTHS);
    }

    /** As it is shown: {@code 2.5}. */
    public static String text(double seconds) {
        return BigDecimal.valueOf(time(seconds)).stripTrailingZeros().toPlainString();
    }

    /** Parses a typed time; empty if a keyframe cannot have it. */
    public static Optional<Double> parse(String typed) {
        try {
            return Optional.of(new BigDecimal(typed.strip().replace(',', '.')).doubleValue())
                    .filter(SceneLimits.KEYFRAME_TIME::contains)
                    .map(KeyframeEdits::time);
        } catch (NumberFormatException _) {
            return Optional.empty();
        }
    }

    /** The keyframe at a time, rounded as {@link #time} does. */
    public static OptionalInt at(List<CameraKeyframe> keyframes, double seconds) {
        return IntStream.range(0, keyframes.size())
                .filter(index -> Math.abs(keyframes.get(index).seconds() - seconds) < 0.5 / HUNDREDTHS)
                .findFirst();
    }

    /** The scene with a keyframe at the camera's present pose, which replaces one at the same time. */
    public static Scene set(Scene scene, double seconds) {
        Camera camera = scene.camera();
        List<CameraKeyframe> others = new ArrayList<>(camera.keyframes());
        at(others, seconds).ifPresent(index -> others.remove(index));
        others.add(CameraKeyframe.of(
                time(seconds), camera.withYawDegrees(nearYaw(others, time(seconds), camera.yawDegrees()))));
        others.sort(Comparator.comparingDouble(CameraKeyframe::seconds));
        return with(scene, others);
    }

    public static Scene deleted(Scene scene, int index) {
        List<CameraKeyframe> others = new ArrayList<>(scene.camera().keyframes());
        others.remove(index);
        return with(scene, others);
    }

    /** The scene with a keyframe moved to another time, which stays between its neighbors. */
    public static Scene moved(Scene scene, int index, double seconds) {
        List<CameraKeyframe> keyframes = new ArrayList<>(scene.camera().keyframes());
        double earliest = index == 0 ? 0 : keyframes.get(index - 1).seconds() + 1 / HUNDREDTHS;
        double latest = index == keyframes.size() - 1
                ? SceneLimits.KEYFRAME_TIME.max()
                : keyframes.get(index + 1).seconds() - 1 / HUNDREDTHS;
        if (earliest > latest) {
            return scene;
        }
        CameraKeyframe keyframe = keyframes.get(index);
        keyframes.set(
                index,
                new CameraKeyframe(
                        Math.clamp(time(seconds), earliest, latest),
                        keyframe.position(),
                        keyframe.yawDegrees(),
                        keyframe.pitchDegrees(),
                        keyframe.fieldOfViewDegrees(),
                        keyframe.focusDistance()));
        return with(scene, keyframes);
    }

    /** The same direction, turned by whole turns so that the camera goes the short way from the keyframe before. */
    private static double nearYaw(List<CameraKeyframe> others, double seconds, double yaw) {
        return others.stream()
                .filter(other -> other.seconds() < seconds)
                .max(Comparator.comparingDouble(CameraKeyframe::seconds))
                .map(before -> yaw + FULL_TURN_DEGREES * Math.rint((before.yawDegrees() - yaw) / FULL_TURN_DEGREES))
                .filter(CameraProperties.YAW.range()::contains)
                .orElse(yaw);
    }

    private static Scene with(Scene scene, List<CameraKeyframe> keyframes) {
        return scene.withCamera(scene.camera().withKeyframes(keyframes));
    }
}
