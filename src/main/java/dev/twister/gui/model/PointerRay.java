package dev.twister.gui.model;

import dev.twister.kernel.CameraRay;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.scene.Vector3;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;

/**
 * The view ray through a place on the picture, by the same code that draws it.
 *
 * @param path as {@link CameraRay} starts it, and {@link Hit} has found what it meets
 * @param body what it meets, or {@link Layout#NOTHING}
 * @param bodies those of the picture
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record PointerRay(float[] path, int body, Bodies bodies) {
    /** The ray through x and y, in pixels from the picture's upper left corner. */
    static PointerRay through(FrameInput input, double x, double y) {
        float[] path = new float[Layout.PATH_LENGTH];
        CameraRay.start(path, (float) x, (float) y, input.view().frame());
        int body = Hit.find(
                path,
                new float[Layout.SCRATCH_LENGTH],
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().looks(),
                input.bodies().meshes(),
                input.variant(false));
        return new PointerRay(path, body, input.bodies());
    }

    /** Meters to what it meets. */
    double distance() {
        return path[Layout.DISTANCE];
    }

    /** One coordinate of the unit direction: 0 for x, 1 for y, 2 for z. */
    double direction(int axis) {
        return path[Layout.DIRECTION + axis];
    }

    /** The point that number of meters along, in the scene. */
    Vector3 along(double meters) {
        Vector3 origin = bodies.origin();
        return new Vector3(
                origin.x() + path[Layout.ORIGIN] + meters * direction(0),
                origin.y() + path[Layout.ORIGIN + 1] + meters * direction(1),
                origin.z() + path[Layout.ORIGIN + 2] + meters * direction(2));
    }
}
