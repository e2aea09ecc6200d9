package dev.twister.mesh;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraView;
import dev.twister.scene.Vector3;

/**
 * A camera of a file.
 *
 * @param fieldOfViewDegrees the angle over the shorter side of the picture
 * @param position in meters
 * @param direction unit vector in which it looks
 */
public record FileCamera(String name, double fieldOfViewDegrees, Vector3 position, Vector3 direction) {
    FileCamera placed(Affine placement) {
        return new FileCamera(
                name,
                fieldOfViewDegrees,
                placement.point(position),
                placement.direction(direction).normalized());
    }

    /** A view of a scene; the horizon is level. */
    CameraView view() {
        double yaw = Math.toDegrees(Math.atan2(direction.x(), direction.z()));
        double pitch = Math.toDegrees(Math.asin(Math.clamp(-direction.y(), -1, 1)));
        return new CameraView(name, Camera.of(position, yaw, pitch, fieldOfViewDegrees));
    }
}
