package dev.twister.kernel;

/** A map on a surface, such as the texture that multiplies its color; bilinear between texel centers. */
public final class Texture {
    private Texture() {}

    /** What is beyond a map's borders: the map again, the border's texels, or every second time the mirrored map. */
    public static final int REPEAT = 0;

    public static final int CLAMP = 1;
    public static final int MIRROR = 2;

    /**
     * Writes {@link Layout#TEXEL}, the place of {@link Layout#POINT} in a map. A sphere's map wraps around it once, so
     * that text is readable from outside, and its first and last rows end at the poles. The plane's map repeats every
     * meter, with its upper edge away from a camera that looks along z. A mesh's uses {@link Layout#TEXTURE_PLACE}.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, with the outward normal
     * @param map its place in {@code looks}
     * @param body any except the light
     */
    public static void aim(float[] path, int map, int body, float[] frame, float[] looks, int variant) {
        int width = (int) looks[map + Layout.MAP_WIDTH];
        int height = (int) looks[map + Layout.MAP_HEIGHT];
        int plane = body == Layout.PLANE ? 1 : 0;
        int mesh = Surface.isMesh(body, frame, variant);
        float u = path[Layout.POINT];
        float v = -path[Layout.POINT + 2];
        if (mesh != 0) {
            u = path[Layout.TEXTURE_PLACE];
            v = path[Layout.TEXTURE_PLACE + 1];
        }
        if ((plane | mesh) != 0) {
            path[Layout.TEXEL] = fraction(u) * width - 0.5f;
            path[Layout.TEXEL + 1] = fraction(v) * height - 0.5f;
            if ((variant & Variant.MAPS) != 0) {
                int sampler = (int) looks[map + Layout.MAP_SAMPLER];
                path[Layout.TEXEL] = place(u, width, sampler % Layout.SAMPLER_DOWN, isNearest(sampler));
                path[Layout.TEXEL + 1] =
                        place(v, height, sampler / Layout.SAMPLER_DOWN % Layout.SAMPLER_DOWN, isNearest(sampler));
            }
        } else {
            aimAround(path, map, path[Layout.NORMAL], path[Layout.NORMAL + 1], path[Layout.NORMAL + 2], looks);
        }
    }

    /** As above on a sphere, by its outward normal. */
    static void aimAround(float[] path, int map, float x, float y, float z, float[] looks) {
        int width = (int) looks[map + Layout.MAP_WIDTH];
        int height = (int) looks[map + Layout.MAP_HEIGHT];
        path[Layout.TEXEL] = SkyLookup.column(x, -z, 0f, width);
        path[Layout.TEXEL + 1] = Math.min(Math.max(SkyLookup.row(x, y, z, height), 0f), height - 1f);
    }

    /** 1 if the nearest texel counts, else 0. */
    public static int isNearest(int sampler) {
        return sampler / Layout.SAMPLER_NEAREST % 2;
    }

    /**
     * The place of a texture coordinate in a map, in texels from the first one's center.
     *
     * @param size the map's, in texels
     * @param wrap what is beyond its borders
     */
    public static float place(float coordinate, int size, int wrap, int nearest) {
        float mirrored = 1f - Math.abs(2f * fraction(0.5f * coordinate) - 1f);
        float inside = wrap == MIRROR ? mirrored : fraction(coordinate);
        float place = (wrap == CLAMP ? coordinate : inside) * size - 0.5f;
        place = wrap == REPEAT ? place : Math.min(Math.max(place, 0f), size - 1f);
        float rounded = Math.min(KernelMath.floor(place + 0.5f), size - 1);
        return nearest != 0 ? rounded : place;
    }

    private static float fraction(float x) {
        return x - KernelMath.floor(x);
    }

    /** 1 if a map's texels are packed, else 0. */
    public static int isPacked(int sampler) {
        return sampler / Layout.SAMPLER_PACKED % 2;
    }

    /** One channel (0 red, 1 green, 2 blue) of a map at {@link Layout#TEXEL}. */
    static float channel(float[] path, int map, int channel, float[] looks, float[] images) {
        return color(
                Layout.ALIGNMENT * (int) looks[map + Layout.MAP_START],
                isPacked((int) looks[map + Layout.MAP_SAMPLER]),
                (int) looks[map + Layout.MAP_WIDTH],
                (int) looks[map + Layout.MAP_HEIGHT],
                path[Layout.TEXEL],
                path[Layout.TEXEL + 1],
                channel,
                images);
    }

    /**
     * As above, of a map that repeats beyond its borders.
     *
     * @param start place of its first texel
     * @param packed 1 if its texels are packed, else 0
     * @param column relative to the first texel's center, in [-0.5, width - 0.5]
     * @param row relative to the first texel's center, in [-0.5, height - 0.5]
     */
    public static float color(
            int start, int packed, int width, int height, float column, float row, int channel, float[] images) {
        int left = leftOf(column, width);
        int right = rightOf(column, width);
        int upper = width * leftOf(row, height);
        int lower = width * rightOf(row, height);
        return between(
                texel(start, packed, upper + left, channel, images),
                texel(start, packed, upper + right, channel, images),
                texel(start, packed, lower + left, channel, images),
                texel(start, packed, lower + right, channel, images),
                column,
                row);
    }

    /** As above, of a map with one float per texel. */
    static float number(int start, int width, int height, float column, float row, float[] texels) {
        int left = leftOf(column, width);
        int right = rightOf(column, width);
        int upper = start + width * leftOf(row, height);
        int lower = start + width * rightOf(row, height);
        return between(
                texels[upper + left], texels[upper + right], texels[lower + left], texels[lower + right], column, row);
    }

    /** One channel of a texel, which is counted from the map's first one. */
    public static float texel(int start, int packed, int texel, int channel, float[] images) {
        int place = start + (packed != 0 ? texel : Layout.TEXEL_STRIDE * texel + channel);
        int code = ((int) images[place] >> (8 * channel)) & 255;
        return images[packed != 0 ? start - Layout.CODES + code : place];
    }

    /** The column to the left of a place, or the row above it. */
    private static int leftOf(float place, int size) {
        int left = KernelMath.floor(place);
        return left < 0 ? size - 1 : Math.min(left, size - 1);
    }

    private static int rightOf(float place, int size) {
        int right = KernelMath.floor(place) + 1;
        return right >= size ? 0 : right;
    }

    private static float between(
            float topLeft, float topRight, float bottomLeft, float bottomRight, float column, float row) {
        float toRight = column - KernelMath.floor(column);
        float upper = topLeft + (topRight - topLeft) * toRight;
        float lower = bottomLeft + (bottomRight - bottomLeft) * toRight;
        return upper + (lower - upper) * (row - KernelMath.floor(row));
    }
}
