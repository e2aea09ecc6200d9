package dev.twister.kernel;

/**
 * What of the picture is drawn: all of it, a stage on the way there, or a view, one value of each sample; a pixel is
 * the mean of its samples. Numbers are the same in all three channels.
 */
public final class Aspect {
    /** Values of the argument {@code aspect}: the picture itself. */
    public static final int FULL = 0;

    /** Stages, of the first hit alone. A ray that misses has the sky, the light its own color. The base color C. */
    public static final int COLORS = 1;

    /** {@code C * max(a, N.L)}: no body comes between, none is a mirror, none transmits. */
    public static final int DIFFUSE = 2;

    /** {@link #DIFFUSE} and {@code lightColor * spec}. */
    public static final int HIGHLIGHTS = 3;

    /** Views of the first hit. C; the light's own color, and 0 where nothing is hit. */
    public static final int ALBEDO = 4;

    /** {@code 0.5 + 0.5 N}, N as the surface is shaded, of the light too; (0, 0, 0) where nothing is hit. */
    public static final int NORMAL = 5;

    /** Meters from the ray's origin, along the ray; 0 where nothing is hit. */
    public static final int DEPTH = 6;

    /** The body's index: 0 the light, 1 the plane, 2 on the spheres; {@link Layout#NOTHING} where nothing is hit. */
    public static final int BODY = 7;

    /** S, of points that face away from the light too; 1 for the light and where nothing is hit. */
    public static final int SHADOW = 8;

    /** Views of the whole path, which count. The rays that were followed after the view ray, reflected or refracted. */
    public static final int BOUNCES = 9;

    /**
     * The rays' and shadows' tests against spheres, the plane and boxes of the hierarchy, as many as the kernel makes.
     */
    public static final int TESTS = 10;

    private Aspect() {}

    /** 1 where it is known at the first hit, else 0. */
    static int endsAtFirstHit(int aspect) {
        return (aspect > FULL ? 1 : 0) & (aspect < BOUNCES ? 1 : 0);
    }

    /** 1 where it is a count of the whole path, else 0. */
    public static int isCount(int aspect) {
        return aspect >= BOUNCES ? 1 : 0;
    }

    /** Begins to count a pixel's samples, where that is what is drawn. */
    static void start(float[] path, int aspect) {
        if (isCount(aspect) != 0) {
            path[Layout.COUNT] = 0f;
        }
    }

    /** Takes the count for the radiance, where that is what is drawn. */
    static void finish(float[] path, int aspect) {
        if (isCount(aspect) != 0) {
            path[Layout.RADIANCE] = path[Layout.COUNT];
            path[Layout.RADIANCE + 1] = path[Layout.COUNT];
            path[Layout.RADIANCE + 2] = path[Layout.COUNT];
        }
    }

    /** Counts, where that is what is drawn. */
    static void count(float[] path, int aspect, int counted, int number) {
        if (aspect == counted) {
            path[Layout.COUNT] = path[Layout.COUNT] + number;
        }
    }
}
