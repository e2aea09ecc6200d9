package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;
import java.util.Optional;

/**
 * Where the camera is at a time of a film, and how it looks.
 *
 * @param seconds since the film's beginning, 0 or more
 * @param position the lens's center, in meters
 * @param yawDegrees turn about y; positive looks right; may be more than a whole turn away from the keyframe before
 * @param pitchDegrees turn about x, in [-90, 90]; positive looks down
 * @param fieldOfViewDegrees in [1, 179]; the camera's own where it is empty
 * @param focusDistance in meters, above 0; the camera's own where it is empty
 */
@Copied
public record CameraKeyframe(
        double seconds,
        Vector3 position,
        double yawDegrees,
        double pitchDegrees,
        Optional<Double> fieldOfViewDegrees,
        Optional<Double> focusDistance)
        implements CameraKeyframeCopy.With {
    public static final CameraKeyframe DEFAULT =
            new CameraKeyframe(0, Vector3.ZERO, 0, 0, Optional.empty(), Optional.empty());

    public CameraKeyframe {
        requireNonNull(position, "position");
        requireNonNull(fieldOfViewDegrees, "fieldOfViewDegrees");
        requireNonNull(focusDistance, "focusDistance");
    }

    /** The camera as it is, at a time in seconds. */
    public static CameraKeyframe of(double seconds, Camera camera) {
        return new CameraKeyframe(
                seconds,
                camera.position(),
                camera.yawDegrees(),
                camera.pitchDegrees(),
                Optional.of(camera.fieldOfViewDegrees()),
                Optional.of(camera.focusDistance()));
    }

    public CameraKeyframe withFieldOfViewDegrees(double newFieldOfViewDegrees) {
        return withFieldOfViewDegrees(Optional.of(newFieldOfViewDegrees));
    }

    public CameraKeyframe withFocusDistance(double newFocusDistance) {
        return withFocusDistance(Optional.of(newFocusDistance));
    }
}
