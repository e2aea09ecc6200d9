package dev.twister.gui.model;

import dev.twister.kernel.Layout;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/**
 * Moves a body with the pointer, in the plane through its center that faces the camera: its distance from the camera,
 * along the view direction, stays, and so does the spot under the pointer.
 */
public final class SphereDrag {
    private final double depth;
    private final Vector3 grip;

    private SphereDrag(double depth, Vector3 grip) {
        this.depth = depth;
        this.grip = grip;
    }

    /** Takes hold of a body whose center lies there, at a place on the picture in pixels. */
    public static SphereDrag start(FrameInput input, Vector3 center, double x, double y) {
        float[] camera = input.view().camera();
        Vector3 seen = input.bodies().seen(center);
        double depth = (seen.x() - camera[Layout.CAMERA_POSITION]) * camera[Layout.CAMERA_FORWARD]
                + (seen.y() - camera[Layout.CAMERA_POSITION + 1]) * camera[Layout.CAMERA_FORWARD + 1]
                + (seen.z() - camera[Layout.CAMERA_POSITION + 2]) * camera[Layout.CAMERA_FORWARD + 2];
        Vector3 held = pointAt(input, depth, x, y);
        return new SphereDrag(depth, new Vector3(center.x() - held.x(), center.y() - held.y(), center.z() - held.z()));
    }

    /** Where the center lies once the pointer is there; the camera may have moved meanwhile. */
    public Vector3 centerAt(FrameInput input, double x, double y) {
        Vector3 held = pointAt(input, depth, x, y);
        return new Vector3(
                SceneLimits.POSITION.clamp(held.x() + grip.x()),
                SceneLimits.POSITION.clamp(held.y() + grip.y()),
                SceneLimits.POSITION.clamp(held.z() + grip.z()));
    }

    private static Vector3 pointAt(FrameInput input, double depth, double x, double y) {
        float[] camera = input.view().camera();
        PointerRay ray = PointerRay.through(input, x, y);
        // Above 0 for every pixel: the field of view is below 180 degrees.
        double forward = 0;
        for (int axis = 0; axis < 3; axis++) {
            forward += ray.direction(axis) * camera[Layout.CAMERA_FORWARD + axis];
        }
        return ray.along(depth / forward);
    }
}
