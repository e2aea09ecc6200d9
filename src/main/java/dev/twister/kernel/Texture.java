package dev.twister.kernel;

/** A texture, bilinear between texel centers, which multiplies a body's color. */
public final class Texture {
    private Texture() {}

    /**
     * Multiplies the albedo at {@link Layout#POINT}. A sphere's texture wraps around it once, so that text is readable
     * from outside, and its first and last rows end at the poles. The plane's texture repeats every meter, with its
     * upper edge away from a camera that looks along z. A mesh's texture repeats and uses {@link Layout#TEXTURE_PLACE}.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, with the outward normal
     * @param body any except the light
     * @param texture its number, from 1 on
     */
    static void multiply(
            float[] path, int body, int texture, float[] frame, float[] looks, float[] images, int variant) {
        int at = (int) frame[Layout.TEXTURES] + Layout.TEXTURE_STRIDE * (texture - 1);
        int start = Layout.ALIGNMENT * (int) looks[at + Layout.TEXTURE_START];
        int width = (int) looks[at + Layout.TEXTURE_WIDTH];
        int height = (int) looks[at + Layout.TEXTURE_HEIGHT];
        float normalX = path[Layout.NORMAL];
        float normalY = path[Layout.NORMAL + 1];
        float normalZ = path[Layout.NORMAL + 2];
        int plane = body == Layout.PLANE ? 1 : 0;
        int mesh = Surface.isMesh(body, frame, variant);
        float u = path[Layout.POINT];
        float v = -path[Layout.POINT + 2];
        if (mesh != 0) {
            u = path[Layout.TEXTURE_PLACE];
            v = path[Layout.TEXTURE_PLACE + 1];
        }
        int repeats = plane | mesh;
        float column = repeats != 0 ? fraction(u) * width - 0.5f : SkyLookup.column(normalX, -normalZ, 0f, width);
        float toPole = Math.min(Math.max(SkyLookup.row(normalX, normalY, normalZ, height), 0f), height - 1f);
        float row = repeats != 0 ? fraction(v) * height - 0.5f : toPole;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.ALBEDO + channel] =
                    path[Layout.ALBEDO + channel] * color(start, width, height, column, row, channel, images);
        }
    }

    private static float fraction(float x) {
        return x - KernelMath.floor(x);
    }

    /**
     * One channel (0 red, 1 green, 2 blue) of a texture, which repeats beyond its borders.
     *
     * @param start place of its first texel
     * @param column relative to the first texel's center, in [-0.5, width - 0.5]
     * @param row relative to the first texel's center, in [-0.5, height - 0.5]
     */
    public static float color(int start, int width, int height, float column, float row, int channel, float[] images) {
        int left = KernelMath.floor(column);
        int top = KernelMath.floor(row);
        float toRight = column - left;
        float toBottom = row - top;
        int wrappedLeft = left < 0 ? width - 1 : Math.min(left, width - 1);
        int wrappedRight = left + 1 >= width ? 0 : left + 1;
        int wrappedTop = top < 0 ? height - 1 : Math.min(top, height - 1);
        int wrappedBottom = top + 1 >= height ? 0 : top + 1;
        int first = start + channel;
        float topLeft = images[first + 3 * (wrappedTop * width + wrappedLeft)];
        float topRight = images[first + 3 * (wrappedTop * width + wrappedRight)];
        float bottomLeft = images[first + 3 * (wrappedBottom * width + wrappedLeft)];
        float bottomRight = images[first + 3 * (wrappedBottom * width + wrappedRight)];
        float upper = topLeft + (topRight - topLeft) * toRight;
        float lower = bottomLeft + (bottomRight - bottomLeft) * toRight;
        return upper + (lower - upper) * toBottom;
    }
}
