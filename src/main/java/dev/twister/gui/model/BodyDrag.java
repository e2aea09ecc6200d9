package dev.twister.gui.model;

import dev.twister.kernel.Layout;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/**
 * Moves a body with the pointer, in the plane through its middle that faces the camera: its distance from the camera,
 * along the view direction, stays, and so does the spot under the pointer.
 */
public final class BodyDrag {
    private final double depth;
    private final Vector3 grip;

    private BodyDrag(double depth, Vector3 grip) {
        this.depth = depth;
        this.grip = grip;
    }

    /**
     * Takes hold of a body at a place on the picture in pixels.
     *
     * @param place the body's position
     * @param middle of the body, which need not be its position
     */
    public static BodyDrag start(FrameInput input, Vector3 place, Vector3 middle, double x, double y) {
        float[] camera = input.view().camera();
        Vector3 seen = input.bodies().seen(middle);
        double depth = (seen.x() - camera[Layout.CAMERA_POSITION]) * camera[Layout.CAMERA_FORWARD]
                + (seen.y() - camera[Layout.CAMERA_POSITION + 1]) * camera[Layout.CAMERA_FORWARD + 1]
                + (seen.z() - camera[Layout.CAMERA_POSITION + 2]) * camera[Layout.CAMERA_FORWARD + 2];
        Vector3 held = pointAt(input, depth, x, y);
        return new BodyDrag(depth, new Vector3(place.x() - held.x(), place.y() - held.y(), place.z() - held.z()));
    }

    /** The body's position once the pointer is there; the camera may have moved meanwhile. */
    public Vector3 placeAt(FrameInput input, double x, double y) {
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
