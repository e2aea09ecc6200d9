package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.Copied;
import java.util.List;

/**
 * Where a picture is seen from, and through which lens.
 *
 * @param position the lens's center, in meters
 * @param yawDegrees turn about y; positive looks right
 * @param pitchDegrees turn about x, in [-90, 90]; positive looks down
 * @param projection of the picture
 * @param fieldOfViewDegrees the angle over the shorter side of the picture, in [1, 179], with a fisheye in [1, 360];
 *     without effect in other projections than these two
 * @param viewHeight what the picture's height shows in the orthographic projection, in meters, above 0
 * @param aperture the lens's radius in meters, 0 or more; with 0, and in panoramas and with a fisheye, all is sharp
 * @param focusDistance how far ahead the plane is that is sharp, in meters, above 0
 * @param keyframes of a film, each later than the one before; empty where the camera stands still
 */
@Copied
public record Camera(
        Vector3 position,
        double yawDegrees,
        double pitchDegrees,
        Projection projection,
        double fieldOfViewDegrees,
        double viewHeight,
        double aperture,
        double focusDistance,
        List<CameraKeyframe> keyframes)
        implements CameraCopy.With {
    /** A pinhole at the origin, level, along z, with a field of view of 60 degrees. */
    public static final Camera DEFAULT =
            new Camera(Vector3.ZERO, 0, 0, Projection.PERSPECTIVE, 60, 10, 0, 10, List.of());

    /** Of a scene file that says nothing of its camera: looks down at the origin from 8 m before it. */
    public static final Camera USUAL = of(new Vector3(0, 2, -8), 0, 10, 45);

    /** How the directions from a camera are laid out in its picture. */
    public enum Projection {
        /** As the eye and most lenses see: straight lines stay straight, what is far is small. */
        PERSPECTIVE,
        /** Without vanishing points: the same size at every distance. */
        ORTHOGRAPHIC,
        /**
         * The whole sphere of directions, as panoramas of skies have it; not distorted in pictures twice as wide as
         * high.
         */
        PANORAMA,
        /** Equidistant: the angle from straight ahead grows evenly from the picture's middle on. */
        FISHEYE;

        /** The largest field of view in degrees. */
        public double maxFieldOfView() {
            return this == FISHEYE ? 360 : 179;
        }
    }

    public Camera {
        requireNonNull(position, "position");
        requireNonNull(projection, "projection");
        keyframes = List.copyOf(keyframes);
    }

    /**
     * Checks all but the keyframes.
     *
     * @throws SceneException if a value is out of range; the message names it
     */
    public void requireInRange() {
        CameraProperties.ALL.forEach(property -> property.requireInRange("camera", this));
        CameraProperties.fieldOfView(projection).require("camera.fieldOfView", fieldOfViewDegrees);
    }

    /** A camera whose other properties are the defaults; angles in degrees. */
    public static Camera of(Vector3 position, double yaw, double pitch, double fieldOfView) {
        return DEFAULT.withPosition(position)
                .withYawDegrees(yaw)
                .withPitchDegrees(pitch)
                .withFieldOfViewDegrees(fieldOfView);
    }
}
