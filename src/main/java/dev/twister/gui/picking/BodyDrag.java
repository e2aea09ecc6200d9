package dev.twister.gui.picking;

import dev.twister.gui.edit.Axis;
import dev.twister.kernel.Layout;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.FrameInput;
import java.util.Optional;

/**
 * Moves a body with the pointer, in the plane through its middle that faces the camera: its distance from the camera,
 * along the view direction, stays, and so does the spot under the pointer. In panoramas and with a fisheye it is moved
 * on a sphere about the camera.
 */
public final class BodyDrag {
    /** Meters: half a square of the plane. */
    private static final double SNAP = 0.5;

    /** Of the squared sine between the pointer's ray and an axis: nearer to it, a pixel is too many meters. */
    private static final double LEAST_ACROSS = 1e-3;

    private final double depth;
    private final Vector3 place;
    private final Vector3 grip;

    private BodyDrag(double depth, Vector3 place, Vector3 grip) {
        this.depth = depth;
        this.place = place;
        this.grip = grip;
    }

    /**
     * Takes hold of a body at a place on the picture in pixels.
     *
     * @param place the body's position
     * @param middle of the body, which need not be its position
     */
    public static BodyDrag start(FrameInput input, Vector3 place, Vector3 middle, double x, double y) {
        float[] camera = input.view().frame();
        Vector3 away = input.bodies()
                .seen(middle)
                .minus(new Vector3(
                        camera[Layout.CAMERA_POSITION],
                        camera[Layout.CAMERA_POSITION + 1],
                        camera[Layout.CAMERA_POSITION + 2]));
        double depth = PointerRay.isRound(input) ? away.length() : away.dot(PointerRay.forward(input));
        Vector3 held = pointAt(input, depth, x, y);
        return new BodyDrag(depth, place, place.minus(held));
    }

    /** The body's position once the pointer is there; the camera may have moved meanwhile. */
    public Vector3 placeAt(FrameInput input, double x, double y) {
        Vector3 held = pointAt(input, depth, x, y);
        return SceneLimits.POSITION.clamp(held.plus(grip));
    }

    /** The same along an axis: where it comes nearest to the pointer's ray. The start where the axis is seen end on. */
    public Vector3 placeAlong(Axis axis, FrameInput input, double x, double y) {
        PointerRay ray = PointerRay.through(input, x, y);
        Vector3 direction = ray.direction();
        Vector3 away = place.minus(grip).minus(ray.along(0));
        double cosine = axis.of(direction);
        double across = 1 - cosine * cosine;
        double forward = away.dot(direction);
        double meters = (cosine * forward - axis.of(away)) / across;
        // Behind the camera the nearest point does not correspond to the pointer.
        boolean seen = across > LEAST_ACROSS && forward + meters * cosine > 0;
        return seen ? SceneLimits.POSITION.clamp(axis.from(place, meters)) : place;
    }

    /** The nearest place whose coordinates are halves of a meter; along an axis, that coordinate alone. */
    public static Vector3 snapped(Vector3 place, Optional<Axis> axis) {
        return new Vector3(
                snapped(place.x(), axis, Axis.X), snapped(place.y(), axis, Axis.Y), snapped(place.z(), axis, Axis.Z));
    }

    private static double snapped(double coordinate, Optional<Axis> axis, Axis own) {
        // Not the negative zero.
        return axis.orElse(own) == own ? SNAP * Math.rint(coordinate / SNAP) + 0.0 : coordinate;
    }

    private static Vector3 pointAt(FrameInput input, double depth, double x, double y) {
        PointerRay ray = PointerRay.through(input, x, y);
        // Above 0 for every pixel: the field of view is below 180 degrees.
        return ray.along(depth / ray.ahead(input));
    }
}
