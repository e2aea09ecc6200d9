package dev.twister.kernel;

/**
 * Guides of denoising, along with the picture: albedo and normal of the first surface that is neither a smooth mirror
 * nor clear glass. Their sums over the samples are in the path. What has no guides has none of this code.
 */
public final class Guides {
    /** Layers of guides in the output: albedo, then normal. */
    public static final int LAYERS = 2;

    /** Surfaces that reflect or transmit a larger part like a mirror or clear glass are looked through. */
    private static final float LEAST_PART = 0.5f;

    private static final float OPEN = 1f;
    private static final float FOUND = 0f;

    private Guides() {}

    /** Resets the sums of a pixel. */
    static void start(float[] path, int variant) {
        if (Views.isGuided(variant) != 0) {
            for (int i = 0; i < 3; i++) {
                path[Layout.GUIDE_ALBEDO + i] = 0f;
                path[Layout.GUIDE_NORMAL + i] = 0f;
            }
        }
    }

    /** Begins a sample. */
    static void begin(float[] path, int variant) {
        if (Views.isGuided(variant) != 0) {
            path[Layout.GUIDE_STATE] = OPEN;
            for (int i = 0; i < 3; i++) {
                path[Layout.GUIDE_TINT + i] = 1f;
            }
        }
    }

    /**
     * The path has met a surface in path tracing, and its next ray is chosen.
     *
     * @param path with the normal turned toward the ray's origin
     */
    static void trace(float[] path, int variant) {
        if (Views.isGuided(variant) != 0) {
            int smooth = path[Layout.ROUGHNESS] > 0f ? 0 : 1;
            int clear = path[Layout.PART_MATTE] < LEAST_PART ? 1 : 0;
            // A density marks a direction that was chosen among many.
            int bent = path[Layout.SURFACE_DENSITY] > 0f ? 0 : 1;
            float carried = path[Layout.THROUGHPUT] + path[Layout.THROUGHPUT + 1] + path[Layout.THROUGHPUT + 2];
            if ((smooth & clear & bent & (carried > 0f ? 1 : 0)) != 0) {
                for (int i = 0; i < 3; i++) {
                    path[Layout.GUIDE_TINT + i] = Math.min(path[Layout.THROUGHPUT + i], 1f);
                }
            } else {
                surface(path);
            }
        }
    }

    /**
     * The path has met a surface in Whitted's tree. Where the tree splits, the guides follow the stronger branch.
     *
     * @param mirror m in [0, 1]
     * @param transmission t in [0, 1]
     */
    static void meet(float[] path, float mirror, float transmission, int variant) {
        if (Views.isGuided(variant) != 0) {
            float roughness = 0f;
            if ((variant & Variant.MATERIALS) != 0) {
                roughness = path[Layout.ROUGHNESS];
            }
            int clear = (1f - mirror) * (1f - transmission) < LEAST_PART ? 1 : 0;
            int passes = (1f - mirror) * transmission >= LEAST_PART ? 1 : 0;
            if ((clear & (roughness > 0f ? 0 : 1)) != 0) {
                if (path[Layout.GUIDE_STATE] == OPEN) {
                    for (int i = 0; i < 3; i++) {
                        path[Layout.GUIDE_TINT + i] = path[Layout.GUIDE_TINT + i]
                                * (passes != 0 ? path[Layout.ALBEDO + i] : Scatter.tint(path, i, variant));
                    }
                }
            } else {
                surface(path);
            }
        }
    }

    /** Rays wait: while the fainter branch is followed, the guides wait for the stronger one. */
    static void split(float[] path, int waitingBefore, int variant) {
        if (Views.isGuided(variant) != 0) {
            int split = path[Layout.WAITING] > waitingBefore ? 1 : 0;
            int open = path[Layout.GUIDE_STATE] == OPEN ? 1 : 0;
            path[Layout.GUIDE_STATE] = (split & open) != 0 ? -path[Layout.WAITING] : path[Layout.GUIDE_STATE];
        }
    }

    /** A waiting ray goes on. */
    static void resume(float[] path, int variant) {
        if (Views.isGuided(variant) != 0) {
            int awaited = path[Layout.GUIDE_STATE] == -1f - path[Layout.WAITING] ? 1 : 0;
            path[Layout.GUIDE_STATE] = awaited != 0 ? OPEN : path[Layout.GUIDE_STATE];
        }
    }

    /** The path has met the sky or a light, whose radiance is its albedo as far as it is at most 1. */
    static void shine(float[] path, float red, float green, float blue, int variant) {
        if (Views.isGuided(variant) != 0) {
            if (path[Layout.GUIDE_STATE] == OPEN) {
                add(path, 0, Math.min(red, 1f));
                add(path, 1, Math.min(green, 1f));
                add(path, 2, Math.min(blue, 1f));
                path[Layout.GUIDE_STATE] = FOUND;
            }
        }
    }

    private static void surface(float[] path) {
        if (path[Layout.GUIDE_STATE] == OPEN) {
            for (int i = 0; i < 3; i++) {
                add(path, i, path[Layout.ALBEDO + i]);
                path[Layout.GUIDE_NORMAL + i] = path[Layout.GUIDE_NORMAL + i] + path[Layout.NORMAL + i];
            }
            path[Layout.GUIDE_STATE] = FOUND;
        }
    }

    private static void add(float[] path, int channel, float albedo) {
        path[Layout.GUIDE_ALBEDO + channel] =
                path[Layout.GUIDE_ALBEDO + channel] + path[Layout.GUIDE_TINT + channel] * albedo;
    }

    /**
     * Stores the means of a pixel's samples.
     *
     * @param layers planes of three floats per pixel
     * @param first place of the first plane
     * @param plane length of a plane
     * @param average 1 / number of samples
     */
    static void store(float[] layers, int first, int plane, float[] path, float average, int variant) {
        if (Views.isGuided(variant) != 0) {
            for (int i = 0; i < 3; i++) {
                layers[first + i] = path[Layout.GUIDE_ALBEDO + i] * average;
                layers[first + plane + i] = path[Layout.GUIDE_NORMAL + i] * average;
            }
        }
    }
}
