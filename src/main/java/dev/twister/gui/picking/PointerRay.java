package dev.twister.gui.picking;

import dev.twister.kernel.CameraRay;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Surface;
import dev.twister.kernel.Variant;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.CameraProperties;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import java.util.function.IntPredicate;

/**
 * The view ray through a place on the picture, by the same code that draws it.
 *
 * @param path as {@link CameraRay} starts it, and {@link Hit} has found what it meets
 * @param body what it meets, or {@link Layout#NOTHING}
 * @param bodies those of the picture
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record PointerRay(float[] path, int body, Bodies bodies) {
    /** Surfaces of bodies that are passed. */
    private static final int MOST_PASSED = 256;

    /** Meters, and of the distance: behind a surface that is passed. */
    private static final float BEHIND = 1e-5f;

    /** The ray through x and y, in pixels from the picture's upper left corner. */
    public static PointerRay through(FrameInput input, double x, double y) {
        float[] path = new float[Layout.PATH_LENGTH];
        CameraRay.start(path, (float) x, (float) y, input.view().frame());
        return new PointerRay(path, hit(path, input), input.bodies());
    }

    /** The ray from behind the bodies that are passed; what it meets is none of them. */
    PointerRay beyond(FrameInput input, IntPredicate passed) {
        float[] further = path.clone();
        int met = body;
        for (int surfaces = 0; surfaces < MOST_PASSED && met != Layout.NOTHING && passed.test(met); surfaces++) {
            float meters = further[Layout.DISTANCE] * (1 + BEHIND) + BEHIND;
            for (int axis = 0; axis < 3; axis++) {
                further[Layout.ORIGIN + axis] += meters * further[Layout.DIRECTION + axis];
            }
            met = hit(further, input);
        }
        return new PointerRay(further, met != Layout.NOTHING && passed.test(met) ? Layout.NOTHING : met, bodies);
    }

    private static int hit(float[] path, FrameInput input) {
        return Hit.find(
                path,
                new float[Layout.SCRATCH_LENGTH],
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().looks(),
                input.bodies().meshes(),
                // Spots can be grabbed where they are not seen, too.
                input.variant(false) & ~Variant.LIGHTS);
    }

    /** The unit normal where it meets the body, to the ray's side. */
    Vector3 normal(FrameInput input) {
        float[] at = path.clone();
        Surface.find(
                at,
                body,
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().meshes(),
                input.variant(false));
        Vector3 normal = new Vector3(at[Layout.NORMAL], at[Layout.NORMAL + 1], at[Layout.NORMAL + 2]);
        return normal.dot(direction()) > 0 ? normal.times(-1) : normal;
    }

    /** Meters to what it meets. */
    public double distance() {
        return path[Layout.DISTANCE];
    }

    /** One coordinate of the unit direction: 0 for x, 1 for y, 2 for z. */
    double direction(int axis) {
        return path[Layout.DIRECTION + axis];
    }

    Vector3 direction() {
        return new Vector3(direction(0), direction(1), direction(2));
    }

    /** How far ahead of the camera a meter along the ray leads; 1 where no plane faces the camera. */
    double ahead(FrameInput input) {
        return isRound(input) ? 1 : direction().dot(forward(input));
    }

    /** Whether the picture has no plane that faces the camera, but spheres about it: a panorama's or a fisheye's. */
    static boolean isRound(FrameInput input) {
        return input.view().frame()[Layout.CAMERA_PROJECTION] > CameraRay.ORTHOGRAPHIC;
    }

    static Vector3 forward(FrameInput input) {
        float[] camera = input.view().frame();
        return new Vector3(
                camera[Layout.CAMERA_FORWARD], camera[Layout.CAMERA_FORWARD + 1], camera[Layout.CAMERA_FORWARD + 2]);
    }

    /** The point that number of meters along, in the scene. */
    Vector3 along(double meters) {
        Vector3 origin = bodies.origin();
        return new Vector3(
                origin.x() + path[Layout.ORIGIN] + meters * direction(0),
                origin.y() + path[Layout.ORIGIN + 1] + meters * direction(1),
                origin.z() + path[Layout.ORIGIN + 2] + meters * direction(2));
    }

    /**
     * The body that is seen there: {@link Layout#LIGHT}, {@link Layout#PLANE}, a sphere's index from
     * {@link Layout#FIRST_SPHERE} on, or {@link Layout#NOTHING} for the sky.
     *
     * @param x in pixels of the picture from its left border
     * @param y in pixels from its upper border
     */
    public static int bodyAt(FrameInput input, double x, double y) {
        return through(input, x, y).body();
    }

    /**
     * The focus distance at which a place on the picture is sharp: along the camera's forward axis, in meters, within
     * what a scene may have; for the sky the largest.
     *
     * @param x in pixels of the picture from its left border
     * @param y in pixels from its upper border
     */
    public static double focusDistance(FrameInput input, double x, double y) {
        PointerRay ray = through(input, x, y);
        if (ray.body() == Layout.NOTHING) {
            return CameraProperties.FOCUS_DISTANCE.range().max();
        }
        return CameraProperties.FOCUS_DISTANCE.range().clamp(ray.distance() * ray.ahead(input));
    }
}
