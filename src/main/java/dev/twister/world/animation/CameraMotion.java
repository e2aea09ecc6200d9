package dev.twister.world.animation;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.SceneLimits;

/** Interactive camera movement, independent of the frame rate. */
public final class CameraMotion {
    public static final double WALK_METERS_PER_SECOND = 5;
    public static final double RUN_METERS_PER_SECOND = 20;

    public static final double TURN_DEGREES_PER_SECOND = 45;
    public static final double FAST_TURN_DEGREES_PER_SECOND = 135;

    /** Minimum height of the camera above the plane, in meters. */
    public static final double CLEARANCE_METERS = 0.1;

    /** Factor for the field of view per notch of the wheel. */
    public static final double ZOOM_OF_A_NOTCH = 0.95;

    private static final double FULL_TURN_DEGREES = 360;

    private CameraMotion() {}

    /**
     * Moves horizontally relative to the view direction, and vertically. Diagonal moves are not faster. The camera
     * stays above the plane.
     *
     * @param seconds time since the last step, at least 0
     */
    public static Camera walk(Camera camera, Walk walk, double seconds, Ground plane) {
        if (walk.isStill()) {
            return camera;
        }
        double length = Math.hypot(Math.hypot(walk.right(), walk.up()), walk.forward());
        double meters = (walk.running() ? RUN_METERS_PER_SECOND : WALK_METERS_PER_SECOND) * seconds;
        double scale = meters / Math.max(1, length);
        double yaw = Math.toRadians(camera.yawDegrees());
        Vector3 direction = new Vector3(
                walk.right() * Math.cos(yaw) + walk.forward() * Math.sin(yaw),
                walk.up(),
                walk.forward() * Math.cos(yaw) - walk.right() * Math.sin(yaw));
        return above(at(camera, camera.position().plus(direction.times(scale))), plane);
    }

    /**
     * Turns the camera.
     *
     * @param seconds time since the last step, at least 0
     */
    public static Camera turn(Camera camera, Turn turn, double seconds) {
        double degrees = (turn.fast() ? FAST_TURN_DEGREES_PER_SECOND : TURN_DEGREES_PER_SECOND) * seconds;
        return turn.right() == 0 && turn.down() == 0
                ? camera
                : look(camera, degrees * turn.right(), degrees * turn.down());
    }

    /** Turns the camera by angles in degrees; yaw ends in [-180, 180), pitch in [-90, 90]. */
    public static Camera look(Camera camera, double rightDegrees, double downDegrees) {
        double yaw = camera.yawDegrees() + rightDegrees;
        return camera.withYawDegrees(yaw - FULL_TURN_DEGREES * Math.floor(yaw / FULL_TURN_DEGREES + 0.5))
                .withPitchDegrees(CameraProperties.PITCH.range().clamp(camera.pitchDegrees() + downDegrees));
    }

    /**
     * Narrows or widens the field of view, or what an orthographic picture shows; a panorama shows all.
     *
     * @param notches of the mouse wheel, positive away from the user; may be fractional
     */
    public static Camera zoom(Camera camera, double notches) {
        double factor = Math.pow(ZOOM_OF_A_NOTCH, notches);
        return switch (camera.projection()) {
            case PERSPECTIVE, FISHEYE ->
                camera.withFieldOfViewDegrees(
                        CameraProperties.fieldOfView(camera.projection()).clamp(camera.fieldOfViewDegrees() * factor));
            case ORTHOGRAPHIC ->
                camera.withViewHeight(CameraProperties.VIEW_HEIGHT.range().clamp(camera.viewHeight() * factor));
            case PANORAMA -> camera;
        };
    }

    /** The camera, raised above the plane if it is below. */
    public static Camera above(Camera camera, Ground plane) {
        double lowest = plane.height() + CLEARANCE_METERS;
        Vector3 position = camera.position();
        return position.y() >= lowest ? camera : at(camera, new Vector3(position.x(), lowest, position.z()));
    }

    private static Camera at(Camera camera, Vector3 position) {
        return camera.withPosition(SceneLimits.POSITION.clamp(position));
    }
}
