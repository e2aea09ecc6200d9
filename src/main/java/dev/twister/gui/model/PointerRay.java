package dev.twister.gui.model;

import dev.twister.kernel.KernelMath;
import dev.twister.kernel.Layout;
import dev.twister.kernel.ViewRay;
import dev.twister.world.FrameInput;

/** The view ray through a place on the picture: origin in metres and unit direction. */
record PointerRay(float originX, float originY, float originZ, float directionX, float directionY, float directionZ) {
    /** As the kernel casts it: x and y in pixels from the picture's upper left corner. */
    static PointerRay through(FrameInput input, double x, double y) {
        float[] camera = input.camera();
        float u = ViewRay.u((float) x, input.width(), input.height());
        float v = ViewRay.v((float) y, input.width(), input.height());
        float directionX = along(camera, u, v, 0);
        float directionY = along(camera, u, v, 1);
        float directionZ = along(camera, u, v, 2);
        float inverse =
                KernelMath.inverseRoot(directionX * directionX + directionY * directionY + directionZ * directionZ);
        return new PointerRay(
                camera[Layout.CAMERA_POSITION],
                camera[Layout.CAMERA_POSITION + 1],
                camera[Layout.CAMERA_POSITION + 2],
                directionX * inverse,
                directionY * inverse,
                directionZ * inverse);
    }

    private static float along(float[] camera, float u, float v, int axis) {
        return u * camera[Layout.CAMERA_RIGHT + axis]
                + v * camera[Layout.CAMERA_UP + axis]
                + camera[Layout.CAMERA_EYE_DISTANCE] * camera[Layout.CAMERA_FORWARD + axis];
    }
}
