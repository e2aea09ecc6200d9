package dev.twister.kernel;

/**
 * Pixels side by side in a row, drawn together, a step at a time: each step is a loop over them, short and without
 * branches, which the compilers of CPUs turn into vector instructions. What a pixel, or lane, has to remember from one
 * step to the next stands in columns of two arrays, a lane's number at {@code COLUMN + lane}.
 */
public final class Strip {
    /** The most pixels of a strip: the last of a row may have fewer. */
    public static final int LANES = 32;

    /** {@code float[] lanes}: the ray, its direction a unit vector. */
    public static final int DIRECTION_X = 0;

    public static final int DIRECTION_Y = LANES;
    public static final int DIRECTION_Z = 2 * LANES;
    public static final int ORIGIN_X = 3 * LANES;
    public static final int ORIGIN_Y = 4 * LANES;
    public static final int ORIGIN_Z = 5 * LANES;

    /** What part of the radiance that the ray brings reaches the pixel. */
    public static final int THROUGHPUT = 6 * LANES;

    /** Linear radiance of the pixel's samples so far, summed up. */
    public static final int RED = 7 * LANES;

    public static final int GREEN = 8 * LANES;
    public static final int BLUE = 9 * LANES;

    /** How far the closest hit is, in metres. */
    public static final int DISTANCE = 10 * LANES;

    /** The hit body's, and the point's colour. */
    public static final int CENTER_X = 11 * LANES;

    public static final int CENTER_Y = 12 * LANES;
    public static final int CENTER_Z = 13 * LANES;
    public static final int RADIUS = 14 * LANES;
    public static final int REFLECTIVITY = 15 * LANES;
    public static final int ALBEDO_RED = 16 * LANES;
    public static final int ALBEDO_GREEN = 17 * LANES;
    public static final int ALBEDO_BLUE = 18 * LANES;

    /** The hit point, its unit normal, the unit vector to the light's centre and how far that is. */
    public static final int POINT_X = 19 * LANES;

    public static final int POINT_Y = 20 * LANES;
    public static final int POINT_Z = 21 * LANES;
    public static final int NORMAL_X = 22 * LANES;
    public static final int NORMAL_Y = 23 * LANES;
    public static final int NORMAL_Z = 24 * LANES;
    public static final int TO_LIGHT_X = 25 * LANES;
    public static final int TO_LIGHT_Y = 26 * LANES;
    public static final int TO_LIGHT_Z = 27 * LANES;
    public static final int LIGHT_DISTANCE = 28 * LANES;
    public static final int NORMAL_DOT_LIGHT = 29 * LANES;

    /** S; the disc's radius seen from 1 m; of the cone to the samples: tangent and inverse cosine of its half angle. */
    public static final int VISIBLE = 30 * LANES;

    public static final int SAMPLE_SCALE = 31 * LANES;
    public static final int SLOPE = 32 * LANES;
    public static final int SLANT = 33 * LANES;

    /** Where in the panorama the ray looks, see {@link SkyLookup}. */
    public static final int SKY_COLUMN = 34 * LANES;

    public static final int SKY_ROW = 35 * LANES;

    /** {@code max(0, N.H)}, and its power. */
    public static final int COSINE = 36 * LANES;

    public static final int POWER = 37 * LANES;

    /** The unit disc's points, {@link Layout#MOST_SHADOW_SAMPLES} of each coordinate, the same for all lanes. */
    public static final int SAMPLE_X = 38 * LANES;

    public static final int SAMPLE_Y = SAMPLE_X + Layout.MOST_SHADOW_SAMPLES;

    public static final int FLOATS = SAMPLE_Y + Layout.MOST_SHADOW_SAMPLES;

    /** {@code int[] marks}: the closest hit's body, {@link Layout#NOTHING}, or {@link #FINISHED}. */
    public static final int HIT = 0;

    /** The body that the ray leaves, {@link Layout#NOTHING}, or {@link #FINISHED}. */
    public static final int LEAVING = LANES;

    /** 1 where spheres may come between the point and the light's disc, else 0. */
    public static final int SHADED = 2 * LANES;

    /** 1 where a sphere has been found that may, else 0. */
    public static final int MET = 3 * LANES;

    /** 1 for each sample that one lane does not see, else 0. */
    public static final int BLOCKED = 4 * LANES;

    public static final int MARKS = BLOCKED + Layout.MOST_SHADOW_SAMPLES;

    /** What stands for a body in lanes whose path has ended. */
    public static final int FINISHED = -2;

    private Strip() {}

    /** How many strips it takes to draw a row. */
    public static int inRow(int width) {
        return (width + LANES - 1) / LANES;
    }

    /** How many lanes have hit a body from {@code least} to {@code most}. */
    static int count(int[] marks, int pixels, int least, int most) {
        int count = 0;
        for (int lane = 0; lane < pixels; lane++) {
            int hit = marks[HIT + lane];
            count = count + ((hit >= least ? 1 : 0) & (hit <= most ? 1 : 0));
        }
        return count;
    }
}
