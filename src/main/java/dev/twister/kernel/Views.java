package dev.twister.kernel;

/**
 * What is rendered: the picture, one of its stages, or a view, which is one value per sample. A pixel is the mean of
 * its samples. Numbers are the same in all three channels.
 */
public final class Views {
    /** Values of what is rendered: the picture itself. */
    public static final int FULL = 0;

    /** Stages, of the first hit only; a miss shows the sky, the light its own color. This one: the base color C. */
    public static final int COLORS = 1;

    /** {@code C * max(a, N.L)}, without shadows, reflection and transmission. */
    public static final int DIFFUSE = 2;

    /** {@link #DIFFUSE} and {@code lightColor * spec}. */
    public static final int HIGHLIGHTS = 3;

    /** Views of the first hit. This one: C, or the light's own color; 0 for a miss. */
    public static final int ALBEDO = 4;

    /** {@code 0.5 + 0.5 N} with the shading normal N, also for the light; (0, 0, 0) for a miss. */
    public static final int NORMAL = 5;

    /** Distance from the ray's origin along the ray, in meters; 0 for a miss. */
    public static final int DEPTH = 6;

    /**
     * The body's number: 0 for the first light, 1 for the plane, from 2 on the spheres, including those not poured yet,
     * then the other lights, then the meshes; {@link Layout#NOTHING} for a miss.
     */
    public static final int BODY = 7;

    /** S, also for points that face away from the light; its mean over several lights; 1 for a light and for a miss. */
    public static final int SHADOW = 8;

    /** Views that count along the whole path. This one: the reflected and refracted rays. */
    public static final int BOUNCES = 9;

    /** The kernel's tests of rays and shadow rays against spheres, triangles, the plane and boxes of the hierarchy. */
    public static final int TESTS = 10;

    /** The picture itself, with {@link Guides} as further layers of the linear output. */
    public static final int GUIDED = 11;

    /** As {@link #GUIDED}, with {@link LightLayers} as further layers. */
    public static final int LAYERED = 12;

    /** As {@link #FULL}, without the background, and with {@link Coverage} as the last layer. */
    public static final int CUT = 13;

    /** As {@link #GUIDED}, without the background, and with {@link Coverage} as the last layer. */
    public static final int CUT_GUIDED = 14;

    /** As {@link #LAYERED}, without the background, and with {@link Coverage} as the last layer. */
    public static final int CUT_LAYERED = 15;

    private Views() {}

    /** 1 if the value is known at the first hit, else 0. */
    public static int endsAtFirstHit(int variant) {
        return (Variant.stageOrView(variant) > FULL ? 1 : 0) & (Variant.stageOrView(variant) < BOUNCES ? 1 : 0);
    }

    /** 1 if the value is a count along the whole path, else 0. */
    public static int isCount(int variant) {
        return (Variant.stageOrView(variant) >= BOUNCES ? 1 : 0) & (Variant.stageOrView(variant) < GUIDED ? 1 : 0);
    }

    /** 1 if the picture has guides, else 0. */
    public static int isGuided(int variant) {
        return (Variant.stageOrView(variant) >= GUIDED ? 1 : 0) & (Variant.stageOrView(variant) == CUT ? 0 : 1);
    }

    /** 1 if the picture has a layer for each group of lights, else 0. */
    public static int isLayered(int variant) {
        return (Variant.stageOrView(variant) == LAYERED ? 1 : 0)
                | (Variant.stageOrView(variant) == CUT_LAYERED ? 1 : 0);
    }

    /** 1 if the picture has no background, else 0. */
    public static int isCut(int variant) {
        return Variant.stageOrView(variant) >= CUT ? 1 : 0;
    }

    /** Resets the count of a pixel, if what is rendered is a count. */
    static void start(float[] path, int variant) {
        if (isCount(variant) != 0) {
            path[Layout.COUNT] = 0f;
        }
    }

    /** Copies the count to the radiance, if what is rendered is a count. */
    static void finish(float[] path, int variant) {
        if (isCount(variant) != 0) {
            path[Layout.RADIANCE] = path[Layout.COUNT];
            path[Layout.RADIANCE + 1] = path[Layout.COUNT];
            path[Layout.RADIANCE + 2] = path[Layout.COUNT];
        }
    }

    /** Adds to the count, if what is rendered is {@code counted}. */
    public static void count(float[] path, int counted, int number, int variant) {
        if (Variant.stageOrView(variant) == counted) {
            path[Layout.COUNT] = path[Layout.COUNT] + number;
        }
    }
}
