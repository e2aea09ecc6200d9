package dev.twister.mesh;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraView;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import java.util.List;

/**
 * What lights a file's meshes, and from where they are seen.
 *
 * @param cameras each has a name of its own
 */
public record FileSurroundings(List<FileLight> lights, List<FileCamera> cameras) {
    public static final FileSurroundings NONE = new FileSurroundings(List.of(), List.of());

    public FileSurroundings {
        lights = List.copyOf(lights);
        cameras = List.copyOf(cameras);
    }

    /** The same in other coordinates. */
    FileSurroundings placed(Affine placement) {
        return new FileSurroundings(
                lights.stream().map(light -> light.placed(placement)).toList(),
                cameras.stream().map(camera -> camera.placed(placement)).toList());
    }

    /**
     * A camera of a file.
     *
     * @param lens its projection, and how much it sees
     * @param position in meters
     * @param direction unit vector in which it looks
     */
    public record FileCamera(String name, Camera lens, Vector3 position, Vector3 direction) {
        FileCamera placed(Affine placement) {
            return at(placement.point(position), placement.direction(direction).normalized());
        }

        /** The same elsewhere. */
        public FileCamera at(Vector3 newPosition, Vector3 newDirection) {
            return new FileCamera(name, lens, newPosition, newDirection);
        }

        /** A view of a scene; the horizon is level. */
        CameraView view() {
            double yaw = Math.toDegrees(Math.atan2(direction.x(), direction.z()));
            double pitch = Math.toDegrees(Math.asin(Math.clamp(-direction.y(), -1, 1)));
            return new CameraView(
                    name, lens.withPosition(position).withYawDegrees(yaw).withPitchDegrees(pitch));
        }
    }

    /**
     * A light of a file, without a size.
     *
     * @param shape what it is, and where it shines
     * @param color linear
     * @param intensity in candela, of a sun in lux
     * @param position in meters; without meaning for a sun
     */
    public record FileLight(LightShape shape, Rgb color, double intensity, Vector3 position) {
        FileLight placed(Affine placement) {
            return at(
                    placement.point(position),
                    placement.direction(shape.direction()).normalized());
        }

        /** The same elsewhere. */
        public FileLight at(Vector3 newPosition, Vector3 newDirection) {
            return new FileLight(shape.withDirection(newDirection), color, intensity, newPosition);
        }
    }
}
