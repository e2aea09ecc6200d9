package dev.twister.kernel;

/** View rays from the camera, by its projection; the paper's viewport extends from -1 to 1 over its shorter side. */
public final class CameraRay {
    /** Through a viewport before the camera. */
    public static final int PERSPECTIVE = 0;

    /** All rays are parallel. */
    public static final int ORTHOGRAPHIC = 1;

    /**
     * All directions: from left to right the turn, from top to bottom the angle from straight up, as skies are read.
     */
    public static final int PANORAMA = 2;

    /** Equidistant: the angle from straight ahead grows evenly from the picture's middle on. */
    public static final int FISHEYE = 3;

    private CameraRay() {}

    /**
     * Starts the path of a camera's view ray, without its lens: origin and direction, no body to leave, a throughput of
     * 1, no surface left and no ray waiting. The radiance is kept.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param x in pixels from the picture's left border
     * @param y in pixels from its top border
     */
    public static void start(float[] path, float x, float y, float[] frame) {
        float projection = frame[Layout.CAMERA_PROJECTION];
        if (projection > PANORAMA) {
            fisheye(path, x, y, frame);
        } else {
            if (projection > ORTHOGRAPHIC) {
                panorama(path, x, y, frame);
            } else {
                if (projection > PERSPECTIVE) {
                    direct(path, 0f, 0f, 1f, frame);
                } else {
                    aim(
                            path,
                            u(x, (int) frame[Layout.WIDTH], (int) frame[Layout.HEIGHT]),
                            v(y, (int) frame[Layout.WIDTH], (int) frame[Layout.HEIGHT]),
                            frame);
                }
            }
        }
        if (projection == ORTHOGRAPHIC) {
            float step = frame[Layout.CAMERA_VIEW_HEIGHT] / frame[Layout.HEIGHT];
            float right = (x - frame[Layout.WIDTH] * 0.5f) * step;
            float up = (frame[Layout.HEIGHT] * 0.5f - y) * step;
            for (int axis = 0; axis < 3; axis++) {
                path[Layout.ORIGIN + axis] = frame[Layout.CAMERA_POSITION + axis]
                        + (right * frame[Layout.CAMERA_RIGHT + axis] + up * frame[Layout.CAMERA_UP + axis]);
            }
        } else {
            path[Layout.ORIGIN] = frame[Layout.CAMERA_POSITION];
            path[Layout.ORIGIN + 1] = frame[Layout.CAMERA_POSITION + 1];
            path[Layout.ORIGIN + 2] = frame[Layout.CAMERA_POSITION + 2];
        }
        path[Layout.LEAVING] = Layout.NOTHING;
        path[Layout.INSIDE] = 0f;
        path[Layout.BOUNCE] = 0f;
        path[Layout.WAITING] = 0f;
        path[Layout.THROUGHPUT] = 1f;
        path[Layout.THROUGHPUT + 1] = 1f;
        path[Layout.THROUGHPUT + 2] = 1f;
    }

    /** Writes the unit direction through (u, v) on the viewport. */
    private static void aim(float[] path, float u, float v, float[] frame) {
        float directionX = turned(u, v, 0, frame);
        float directionY = turned(u, v, 1, frame);
        float directionZ = turned(u, v, 2, frame);
        float inverse =
                KernelMath.inverseRoot(directionX * directionX + directionY * directionY + directionZ * directionZ);
        path[Layout.DIRECTION] = directionX * inverse;
        path[Layout.DIRECTION + 1] = directionY * inverse;
        path[Layout.DIRECTION + 2] = directionZ * inverse;
    }

    private static void panorama(float[] path, float x, float y, float[] frame) {
        float turns = x / frame[Layout.WIDTH];
        float fromUp = y / frame[Layout.HEIGHT] * 0.5f;
        float level = KernelMath.sineOfTurns(fromUp);
        // The picture's middle is half a turn from its border, and straight ahead.
        float right = -level * KernelMath.sineOfTurns(turns);
        float forward = -level * KernelMath.cosineOfTurns(turns);
        direct(path, right, KernelMath.cosineOfTurns(fromUp), forward, frame);
    }

    private static void fisheye(float[] path, float x, float y, float[] frame) {
        float u = u(x, (int) frame[Layout.WIDTH], (int) frame[Layout.HEIGHT]);
        float v = v(y, (int) frame[Layout.WIDTH], (int) frame[Layout.HEIGHT]);
        float away = (float) Math.sqrt(u * u + v * v);
        float turns = away * frame[Layout.CAMERA_HALF_FIELD];
        float ahead = turns < 0.5f ? turns : 0.5f;
        float across = away > 0f ? KernelMath.sineOfTurns(ahead) / away : 0f;
        direct(path, across * u, across * v, KernelMath.cosineOfTurns(ahead), frame);
    }

    /** Writes a direction along the camera's axes, normalized. */
    private static void direct(float[] path, float right, float up, float forward, float[] frame) {
        float inverse = KernelMath.inverseRoot(right * right + up * up + forward * forward);
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.DIRECTION + axis] = inverse
                    * (right * frame[Layout.CAMERA_RIGHT + axis]
                            + up * frame[Layout.CAMERA_UP + axis]
                            + forward * frame[Layout.CAMERA_FORWARD + axis]);
        }
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
