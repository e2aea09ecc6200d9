package dev.twister.kernel;

/**
 * How much of the background a pixel's samples see, along with a picture without background: alpha is what is left. A
 * sample sees the background by its view ray, straight on through blended surfaces; mirrors and glass cover it. What
 * the sample sees of it is not added to the picture. What has a background has none of this code.
 */
final class Coverage {
    private static final float OPEN = 1f;
    private static final float CLOSED = 0f;

    private Coverage() {}

    /** Resets the sum of a pixel. */
    static void start(float[] path, int variant) {
        if (Views.isCut(variant) != 0) {
            path[Layout.UNCOVERED] = 0f;
        }
    }

    /** Begins a sample of Whitted's tree. */
    static void begin(float[] path, int variant) {
        if (Views.isCut(variant) != 0) {
            path[Layout.SIGHT] = OPEN;
        }
    }

    /** 1 if the ray of a traced path, which meets nothing, sees the background, else 0. */
    static int traces(int bounce, int variant) {
        int sees = 0;
        if (Views.isCut(variant) != 0) {
            sees = bounce == 0 ? 1 : 0;
        }
        return sees;
    }

    /** 1 if the ray of Whitted's tree, which meets nothing, sees the background, else 0. */
    static int sees(float[] path, int variant) {
        int sees = 0;
        if (Views.isCut(variant) != 0) {
            sees = path[Layout.SIGHT] == OPEN ? 1 : 0;
        }
        return sees;
    }

    /** Adds what the ray sees of the background. */
    static void add(float[] path) {
        path[Layout.UNCOVERED] = path[Layout.UNCOVERED]
                + (path[Layout.THROUGHPUT] + path[Layout.THROUGHPUT + 1] + path[Layout.THROUGHPUT + 2]) * (1f / 3f);
    }

    /**
     * The path has met a surface in Whitted's tree, and its next rays are known. The view goes on through a blended
     * surface; while the reflected ray is followed first, the view waits.
     */
    static void split(float[] path, int body, int waitingBefore, float[] frame, float[] looks, int variant) {
        if (Views.isCut(variant) != 0) {
            if (path[Layout.SIGHT] == OPEN) {
                int blended = 0;
                if ((variant & Variant.MASKS) != 0) {
                    blended = Opacity.cutoff(body, frame, looks) == Layout.BLENDED ? 1 : 0;
                }
                float inside = path[Layout.INSIDE];
                int passes = (inside == Layout.CROSSED_INTO ? 1 : 0) | (inside == Layout.CROSSED_OUT ? 1 : 0);
                float waits = path[Layout.WAITING] > waitingBefore ? -path[Layout.WAITING] : CLOSED;
                float through = passes != 0 ? OPEN : waits;
                path[Layout.SIGHT] = blended != 0 ? through : CLOSED;
            }
        }
    }

    /** A waiting ray goes on. */
    static void resume(float[] path, int variant) {
        if (Views.isCut(variant) != 0) {
            float waits = path[Layout.SIGHT] == OPEN ? CLOSED : path[Layout.SIGHT];
            path[Layout.SIGHT] = waits == -1f - path[Layout.WAITING] ? OPEN : waits;
        }
    }

    /**
     * Stores alpha, in [0, 1], in all three channels.
     *
     * @param first place of the pixel in the layer's plane
     */
    static void store(float[] layers, int first, float[] path, float[] frame, int variant) {
        if (Views.isCut(variant) != 0) {
            float alpha = Math.max(0f, 1f - path[Layout.UNCOVERED] / (int) frame[Layout.PIXEL_SAMPLES]);
            layers[first] = alpha;
            layers[first + 1] = alpha;
            layers[first + 2] = alpha;
        }
    }
}
