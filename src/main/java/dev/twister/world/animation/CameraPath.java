package dev.twister.world.animation;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Position of the camera at a time of a film. */
public final class CameraPath {
    private static final double FULL_TURN_DEGREES = 360;

    private CameraPath() {}

    /**
     * The camera on its path through the keyframes: cubic Hermite curves with Catmull-Rom tangents, with continuous
     * speed. It rests before the first and after the last keyframe; without keyframes it does not move.
     *
     * @param seconds time since the start of the film
     */
    public static Camera at(Camera camera, double seconds) {
        List<CameraKeyframe> keyframes = camera.keyframes();
        if (keyframes.isEmpty()) {
            return camera;
        }
        Curve curve = Curve.at(keyframes, seconds);
        Vector3 position = new Vector3(
                curve.value(key -> key.position().x(), SceneLimits.POSITION),
                curve.value(key -> key.position().y(), SceneLimits.POSITION),
                curve.value(key -> key.position().z(), SceneLimits.POSITION));
        return camera.withPosition(position)
                .withYawDegrees(curve.value(CameraKeyframe::yawDegrees, CameraProperties.YAW.range()))
                .withPitchDegrees(curve.value(CameraKeyframe::pitchDegrees, CameraProperties.PITCH.range()))
                .withFieldOfViewDegrees(curve.value(
                        key -> key.fieldOfViewDegrees().orElse(camera.fieldOfViewDegrees()),
                        CameraProperties.fieldOfView(camera.projection())))
                .withFocusDistance(curve.value(
                        key -> key.focusDistance().orElse(camera.focusDistance()),
                        CameraProperties.FOCUS_DISTANCE.range()));
    }

    /**
     * The camera on a circle around the spheres' center, or around the y axis if there are no spheres. It turns so that
     * it keeps the same view of the center.
     *
     * @param turns number of turns; positive moves to the left and turns the view to the right
     */
    public static Camera onCircle(Camera camera, List<Sphere> spheres, double turns) {
        double x = spheres.stream()
                .mapToDouble(sphere -> sphere.position().x())
                .average()
                .orElse(0);
        double z = spheres.stream()
                .mapToDouble(sphere -> sphere.position().z())
                .average()
                .orElse(0);
        double part = turns - Math.floor(turns);
        double sine = Math.sin(2 * Math.PI * part);
        double cosine = Math.cos(2 * Math.PI * part);
        Vector3 from = camera.position();
        double right = from.x() - x;
        double ahead = from.z() - z;
        return camera.withPosition(new Vector3(
                        SceneLimits.POSITION.clamp(x + right * cosine + ahead * sine),
                        from.y(),
                        SceneLimits.POSITION.clamp(z + ahead * cosine - right * sine)))
                .withYawDegrees(camera.yawDegrees() + FULL_TURN_DEGREES * part);
    }

    /**
     * A segment of the path, between two keyframes.
     *
     * @param index index of its first keyframe
     * @param part part of the time to the next keyframe, in [0, 1]
     */
    private record Curve(List<CameraKeyframe> keyframes, int index, double part) {
        static Curve at(List<CameraKeyframe> keyframes, double seconds) {
            int last = keyframes.size() - 1;
            if (last == 0 || seconds <= keyframes.getFirst().seconds()) {
                return new Curve(keyframes, 0, 0);
            }
            int index = 0;
            while (index < last - 1 && keyframes.get(index + 1).seconds() <= seconds) {
                index++;
            }
            double start = keyframes.get(index).seconds();
            double length = keyframes.get(index + 1).seconds() - start;
            return new Curve(keyframes, index, Math.min(1, (seconds - start) / length));
        }

        double value(ToDoubleFunction<CameraKeyframe> of, Range range) {
            double from = of.applyAsDouble(keyframes.get(index));
            if (part == 0) {
                return from;
            }
            double to = of.applyAsDouble(keyframes.get(index + 1));
            double length =
                    keyframes.get(index + 1).seconds() - keyframes.get(index).seconds();
            double left = 1 - part;
            double curve = left * left * (1 + 2 * part) * from
                    + part * left * left * length * slope(of, index)
                    + part * part * (3 - 2 * part) * to
                    - part * part * left * length * slope(of, index + 1);
            return range.clamp(curve);
        }

        // One-sided at both ends of the path.
        private double slope(ToDoubleFunction<CameraKeyframe> of, int at) {
            CameraKeyframe before = keyframes.get(Math.max(0, at - 1));
            CameraKeyframe after = keyframes.get(Math.min(keyframes.size() - 1, at + 1));
            return (of.applyAsDouble(after) - of.applyAsDouble(before)) / (after.seconds() - before.seconds());
        }
    }
}
