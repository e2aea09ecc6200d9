package dev.twister.gui.model;

import dev.twister.scene.Camera;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Vector3;
import dev.twister.world.CameraMotion;

/** Moves the camera about a point of the scene, as 3D programs do. */
public final class Orbit {
    /** Around a framed body, so that it does not touch the picture's edges. */
    private static final double ROOM = 1.4;

    /** Meters: nearer to the pivot no dolly leads. */
    private static final double NEAREST = 0.05;

    private Orbit() {}

    /** The camera's unit vectors in the scene. */
    private record Axes(Vector3 right, Vector3 up, Vector3 forward) {
        static Axes of(Camera camera) {
            double yaw = Math.toRadians(camera.yawDegrees());
            double pitch = Math.toRadians(camera.pitchDegrees());
            return new Axes(
                    new Vector3(Math.cos(yaw), 0, -Math.sin(yaw)),
                    new Vector3(Math.sin(yaw) * Math.sin(pitch), Math.cos(pitch), Math.cos(yaw) * Math.sin(pitch)),
                    new Vector3(Math.sin(yaw) * Math.cos(pitch), -Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)));
        }

        /** The point that is so far to the right, up and forward of another one. */
        Vector3 from(Vector3 place, double toRight, double toUp, double toForward) {
            return new Vector3(
                    place.x() + toRight * right.x() + toUp * up.x() + toForward * forward.x(),
                    place.y() + toRight * right.y() + toUp * up.y() + toForward * forward.y(),
                    place.z() + toRight * right.z() + toUp * up.z() + toForward * forward.z());
        }
    }

    /** Turns about the pivot, which stays where it is in the picture. */
    public static Camera turned(Camera camera, Vector3 pivot, double rightDegrees, double downDegrees) {
        Axes before = Axes.of(camera);
        Vector3 away = minus(pivot, camera.position());
        Camera turned = CameraMotion.look(camera, rightDegrees, downDegrees);
        Axes after = Axes.of(turned);
        return at(
                turned,
                after.from(pivot, -dot(away, before.right()), -dot(away, before.up()), -dot(away, before.forward())));
    }

    /** Moves across the view, in meters. */
    public static Camera panned(Camera camera, double right, double up) {
        return at(camera, Axes.of(camera).from(camera.position(), right, up, 0));
    }

    /** Moves to the pivot or away from it: the distance becomes that share of what it is. */
    public static Camera dollied(Camera camera, Vector3 pivot, double share) {
        Vector3 away = minus(camera.position(), pivot);
        double distance = Math.sqrt(dot(away, away));
        double scale = distance == 0 ? 1 : Math.max(share, NEAREST / distance);
        return at(
                camera,
                new Vector3(pivot.x() + scale * away.x(), pivot.y() + scale * away.y(), pivot.z() + scale * away.z()));
    }

    /** Looks the same way, from where a sphere fills most of the picture. */
    public static Camera framed(Camera camera, Vector3 center, double radius) {
        double half = Math.toRadians(camera.fieldOfViewDegrees()) / 2;
        return at(camera, Axes.of(camera).from(center, 0, 0, -ROOM * radius / Math.sin(half)));
    }

    /** The point straight ahead at a distance in meters. */
    public static Vector3 ahead(Camera camera, double meters) {
        return Axes.of(camera).from(camera.position(), 0, 0, meters);
    }

    private static Camera at(Camera camera, Vector3 place) {
        return camera.withPosition(new Vector3(
                SceneLimits.POSITION.clamp(place.x()),
                SceneLimits.POSITION.clamp(place.y()),
                SceneLimits.POSITION.clamp(place.z())));
    }

    private static Vector3 minus(Vector3 one, Vector3 other) {
        return new Vector3(one.x() - other.x(), one.y() - other.y(), one.z() - other.z());
    }

    private static double dot(Vector3 one, Vector3 other) {
        return one.x() * other.x() + one.y() * other.y() + one.z() * other.z();
    }
}
