package dev.twister.gui.studio;

import dev.twister.scene.Camera;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.animation.CameraMotion;

/** Moves the camera about a point of the scene, as 3D programs do. */
public final class Orbit {
    /** Around a framed body, so that it does not touch the picture's edges. */
    private static final double ROOM = 1.4;

    /** Meters: nearer to the pivot no dolly leads. */
    private static final double NEAREST = 0.05;

    /** Degrees: a fisheye of a wider field is framed as one of this. */
    private static final double HALF_SPACE = 180;

    /** Radii of a framed body from its middle to a camera whose distance does not decide how large it is. */
    private static final double USUAL_RADII = 3;

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
            return place.plus(right.times(toRight)).plus(up.times(toUp)).plus(forward.times(toForward));
        }
    }

    /** Turns about the pivot, which stays where it is in the picture. */
    public static Camera turned(Camera camera, Vector3 pivot, double rightDegrees, double downDegrees) {
        Axes before = Axes.of(camera);
        Vector3 away = pivot.minus(camera.position());
        Camera turned = CameraMotion.look(camera, rightDegrees, downDegrees);
        Axes after = Axes.of(turned);
        return at(
                turned,
                after.from(pivot, -away.dot(before.right()), -away.dot(before.up()), -away.dot(before.forward())));
    }

    /** Moves across the view, in meters. */
    public static Camera panned(Camera camera, double right, double up) {
        return at(camera, Axes.of(camera).from(camera.position(), right, up, 0));
    }

    /** Moves to the pivot or away from it: the distance becomes that share of what it is. */
    public static Camera dollied(Camera camera, Vector3 pivot, double share) {
        Vector3 away = camera.position().minus(pivot);
        double distance = away.length();
        double scale = distance == 0 ? 1 : Math.max(share, NEAREST / distance);
        return at(camera, pivot.plus(away.times(scale)));
    }

    /** Keeps the direction and moves to where a sphere fills most of the picture. */
    public static Camera framed(Camera camera, Vector3 center, double radius) {
        double share = switch (camera.projection()) {
            case PERSPECTIVE, FISHEYE ->
                Math.sin(Math.toRadians(Math.min(camera.fieldOfViewDegrees(), HALF_SPACE)) / 2);
            case ORTHOGRAPHIC, PANORAMA -> 1 / USUAL_RADII;
        };
        Camera seen = camera.projection() == Camera.Projection.ORTHOGRAPHIC
                ? camera.withViewHeight(CameraProperties.VIEW_HEIGHT.range().clamp(2 * ROOM * radius))
                : camera;
        return at(seen, Axes.of(camera).from(center, 0, 0, -ROOM * radius / share));
    }

    /** The point straight ahead at a distance in meters. */
    public static Vector3 ahead(Camera camera, double meters) {
        return Axes.of(camera).from(camera.position(), 0, 0, meters);
    }

    private static Camera at(Camera camera, Vector3 place) {
        return camera.withPosition(SceneLimits.POSITION.clamp(place));
    }
}
