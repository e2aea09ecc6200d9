package dev.twister.kernel;

/** The panorama: equirectangular, bilinear between texel centers, wrapped horizontally, clamped vertically. */
public final class SkyLookup {
    private static final float TURNS_PER_RADIAN = 0.15915494f;
    private static final float HALF_TURNS_PER_RADIAN = 0.31830987f;

    private SkyLookup() {}

    /**
     * Adds the sky in the direction of the path's ray.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     */
    public static void add(float[] path, float[] frame, float[] images) {
        int width = (int) frame[Layout.SKY_WIDTH];
        int height = (int) frame[Layout.SKY_HEIGHT];
        float column = column(path[Layout.DIRECTION], path[Layout.DIRECTION + 2], frame[Layout.SKY_TURN], width);
        float row = row(path[Layout.DIRECTION], path[Layout.DIRECTION + 1], path[Layout.DIRECTION + 2], height);
        float strength = frame[Layout.SKY_STRENGTH];
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.RADIANCE + channel] = path[Layout.RADIANCE + channel]
                    + path[Layout.THROUGHPUT + channel]
                            * strength
                            * radiance(width, height, column, row, channel, images);
        }
    }

    /**
     * Writes the sky's radiance in a direction.
     *
     * @param direction place of the unit vector in the path
     * @param at place of the radiance, three floats
     */
    public static void write(float[] path, int direction, int at, float[] frame, float[] images) {
        int width = (int) frame[Layout.SKY_WIDTH];
        int height = (int) frame[Layout.SKY_HEIGHT];
        float x = path[direction];
        float y = path[direction + 1];
        float z = path[direction + 2];
        float column = column(x, z, frame[Layout.SKY_TURN], width);
        float row = row(x, y, z, height);
        float strength = frame[Layout.SKY_STRENGTH];
        for (int channel = 0; channel < 3; channel++) {
            path[at + channel] = strength * radiance(width, height, column, row, channel, images);
        }
    }

    /**
     * The column relative to the first texel's center, in [-0.5, width - 0.5]: {@code (0.5 + atan2(x, z) / 2 pi - turn)
     * * width - 0.5}, wrapped.
     *
     * @param turn rotation of the panorama to the right, in turns, in [0, 1)
     */
    public static float column(float x, float z, float turn, int width) {
        float u = 0.5f + KernelMath.atan2(x, z) * TURNS_PER_RADIAN - turn;
        return (u < 0f ? u + 1f : u) * width - 0.5f;
    }

    /**
     * The row relative to the first texel's center, in [-0.5, height - 0.5]: {@code (0.5 - asin(y) / pi) * height -
     * 0.5}. The arc sine is computed by an arc tangent, which stays accurate near zenith and nadir.
     */
    public static float row(float x, float y, float z, int height) {
        float elevation = KernelMath.atan2(y, (float) Math.sqrt(x * x + z * z));
        return (0.5f - elevation * HALF_TURNS_PER_RADIAN) * height - 0.5f;
    }

    /** Linear radiance of one channel (0 red, 1 green, 2 blue) at a column and row as above. */
    public static float radiance(int width, int height, float column, float row, int channel, float[] images) {
        int left = KernelMath.floor(column);
        int top = KernelMath.floor(row);
        float toRight = column - left;
        float toBottom = row - top;
        int wrappedLeft = left < 0 ? left + width : Math.min(left, width - 1);
        int wrappedRight = left + 1 >= width ? 0 : left + 1;
        int clampedTop = Math.min(Math.max(top, 0), height - 1);
        int clampedBottom = Math.min(Math.max(top + 1, 0), height - 1);
        float topLeft = images[3 * (clampedTop * width + wrappedLeft) + channel];
        float topRight = images[3 * (clampedTop * width + wrappedRight) + channel];
        float bottomLeft = images[3 * (clampedBottom * width + wrappedLeft) + channel];
        float bottomRight = images[3 * (clampedBottom * width + wrappedRight) + channel];
        float upper = topLeft + (topRight - topLeft) * toRight;
        float lower = bottomLeft + (bottomRight - bottomLeft) * toRight;
        return upper + (lower - upper) * toBottom;
    }
}
