package dev.twister.kernel;

/** View rays, from the camera through the viewport, whose shorter side runs from -1 to 1. */
public final class Camera {
    private Camera() {}

    /**
     * Starts the path of a pinhole's view ray: its origin and direction, no body to leave, a throughput of 1. Its
     * radiance stays as it is.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param x in pixels from the picture's left border
     * @param y in pixels from its upper border
     * @param dimensions {@link Layout#DIMENSIONS_LENGTH} ints
     * @param camera {@link Layout#CAMERA_LENGTH} floats
     */
    public static void start(float[] path, float x, float y, int[] dimensions, float[] camera) {
        float u = u(x, dimensions[Layout.WIDTH], dimensions[Layout.HEIGHT]);
        float v = v(y, dimensions[Layout.WIDTH], dimensions[Layout.HEIGHT]);
        float directionX = turned(u, v, camera, 0);
        float directionY = turned(u, v, camera, 1);
        float directionZ = turned(u, v, camera, 2);
        float inverse =
                KernelMath.inverseRoot(directionX * directionX + directionY * directionY + directionZ * directionZ);
        path[Layout.DIRECTION] = directionX * inverse;
        path[Layout.DIRECTION + 1] = directionY * inverse;
        path[Layout.DIRECTION + 2] = directionZ * inverse;
        path[Layout.ORIGIN] = camera[Layout.CAMERA_POSITION];
        path[Layout.ORIGIN + 1] = camera[Layout.CAMERA_POSITION + 1];
        path[Layout.ORIGIN + 2] = camera[Layout.CAMERA_POSITION + 2];
        path[Layout.LEAVING] = Layout.NOTHING;
        path[Layout.INSIDE] = 0f;
        path[Layout.THROUGHPUT] = 1f;
        path[Layout.THROUGHPUT + 1] = 1f;
        path[Layout.THROUGHPUT + 2] = 1f;
    }

    /** From left to right; the middle of the width is exactly 0. */
    public static float u(float x, int width, int height) {
        return (x - width * 0.5f) * step(width, height);
    }

    /** From bottom to top. */
    public static float v(float y, int width, int height) {
        return (height * 0.5f - y) * step(width, height);
    }

    /** From one pixel to the next. */
    public static float step(int width, int height) {
        return 2f / (width > height ? height : width);
    }

    /**
     * One coordinate of the ray through a place of the viewport, not yet a unit vector's.
     *
     * @param axis 0 for x, 1 for y, 2 for z
     */
    public static float turned(float u, float v, float[] camera, int axis) {
        return u * camera[Layout.CAMERA_RIGHT + axis]
                + v * camera[Layout.CAMERA_UP + axis]
                + camera[Layout.CAMERA_EYE_DISTANCE] * camera[Layout.CAMERA_FORWARD + axis];
    }
}
