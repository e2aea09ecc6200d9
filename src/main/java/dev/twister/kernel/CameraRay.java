package dev.twister.kernel;

/** View rays from the camera through the viewport, whose shorter side extends from -1 to 1. */
public final class CameraRay {
    private CameraRay() {}

    /**
     * Starts the path of a pinhole camera's view ray: origin and direction, no body to leave, a throughput of 1, no
     * surface left and no ray waiting. The radiance is kept.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param x in pixels from the picture's left border
     * @param y in pixels from its top border
     */
    public static void start(float[] path, float x, float y, float[] frame) {
        float u = u(x, (int) frame[Layout.WIDTH], (int) frame[Layout.HEIGHT]);
        float v = v(y, (int) frame[Layout.WIDTH], (int) frame[Layout.HEIGHT]);
        float directionX = turned(u, v, 0, frame);
        float directionY = turned(u, v, 1, frame);
        float directionZ = turned(u, v, 2, frame);
        float inverse =
                KernelMath.inverseRoot(directionX * directionX + directionY * directionY + directionZ * directionZ);
        path[Layout.DIRECTION] = directionX * inverse;
        path[Layout.DIRECTION + 1] = directionY * inverse;
        path[Layout.DIRECTION + 2] = directionZ * inverse;
        path[Layout.ORIGIN] = frame[Layout.CAMERA_POSITION];
        path[Layout.ORIGIN + 1] = frame[Layout.CAMERA_POSITION + 1];
        path[Layout.ORIGIN + 2] = frame[Layout.CAMERA_POSITION + 2];
        path[Layout.LEAVING] = Layout.NOTHING;
        path[Layout.INSIDE] = 0f;
        path[Layout.BOUNCE] = 0f;
        path[Layout.WAITING] = 0f;
        path[Layout.THROUGHPUT] = 1f;
        path[Layout.THROUGHPUT + 1] = 1f;
        path[Layout.THROUGHPUT + 2] = 1f;
    }

    /** Viewport coordinate from left to right; exactly 0 at the center. */
    public static float u(float x, int width, int height) {
        return (x - width * 0.5f) * step(width, height);
    }

    /** Viewport coordinate from bottom to top. */
    public static float v(float y, int width, int height) {
        return (height * 0.5f - y) * step(width, height);
    }

    /** Distance between adjacent pixels on the viewport. */
    public static float step(int width, int height) {
        return 2f / (width > height ? height : width);
    }

    /**
     * One component of the ray's direction through (u, v) on the viewport; the vector is not normalized.
     *
     * @param axis 0 for x, 1 for y, 2 for z
     */
    public static float turned(float u, float v, int axis, float[] frame) {
        return u * frame[Layout.CAMERA_RIGHT + axis]
                + v * frame[Layout.CAMERA_UP + axis]
                + frame[Layout.CAMERA_EYE_DISTANCE] * frame[Layout.CAMERA_FORWARD + axis];
    }
}
