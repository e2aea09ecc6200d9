package dev.twister.scene;

/**
 * Where a picture is seen from.
 *
 * @param position the rays' origin, in meters
 * @param yawDegrees turn about y; positive looks right
 * @param pitchDegrees turn about x, in [-90, 90]; positive looks down
 * @param fieldOfViewDegrees the angle over the shorter side of the picture, in [1, 179]
 */
public record Camera(Vector3 position, double yawDegrees, double pitchDegrees, double fieldOfViewDegrees) {
    /** At the origin, level, along z, with a field of view of 60 degrees. */
    static final Camera DEFAULT = new Camera(new Vector3(0, 0, 0), 0, 0, 60);

    /** A camera whose other properties are the defaults; angles in degrees. */
    public static Camera of(Vector3 position, double yaw, double pitch, double fieldOfView) {
        return DEFAULT.withPosition(position).withYaw(yaw).withPitch(pitch).withFieldOfView(fieldOfView);
    }

    public Camera withPosition(Vector3 newPosition) {
        return new Camera(newPosition, yawDegrees, pitchDegrees, fieldOfViewDegrees);
    }

    public Camera withYaw(double newYawDegrees) {
        return new Camera(position, newYawDegrees, pitchDegrees, fieldOfViewDegrees);
    }

    public Camera withPitch(double newPitchDegrees) {
        return new Camera(position, yawDegrees, newPitchDegrees, fieldOfViewDegrees);
    }

    public Camera withFieldOfView(double newFieldOfViewDegrees) {
        return new Camera(position, yawDegrees, pitchDegrees, newFieldOfViewDegrees);
    }
}
