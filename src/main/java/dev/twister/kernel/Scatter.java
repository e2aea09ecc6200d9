package dev.twister.kernel;

/** What a surface sends back along the path, and the ray that goes on from it. */
public final class Scatter {
    private Scatter() {}

    /**
     * Adds {@code T * (lightColor * spec + (1 - k) * C * lit)} to the radiance and leaves {@code T * k * lit} as the
     * throughput, which is the design's recursion unrolled.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param visible S in [0, 1]
     * @param last 1 where no ray may go on, so that k is 0, else 0
     * @param ambient in [0, 1]
     * @param looks {@link Layout#LOOK_STRIDE} floats a body
     */
    public static void shade(float[] path, float visible, int last, float ambient, float[] looks) {
        float throughput = path[Layout.THROUGHPUT];
        float lit = Light.lit(ambient, path[Layout.NORMAL_DOT_LIGHT], visible);
        float specular = Light.highlight(path, visible);
        float mirror = last != 0 ? 0f : path[Layout.REFLECTIVITY] / Layout.MAX_REFLECTIVITY;
        float matte = (1f - mirror) * lit;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.RADIANCE + channel] = path[Layout.RADIANCE + channel]
                    + throughput
                            * (looks[Layout.LOOK_STRIDE * Layout.LIGHT + channel] * specular
                                    + matte * path[Layout.ALBEDO + channel]);
        }
        path[Layout.THROUGHPUT] = throughput * (mirror * lit);
    }

    /** Mirrors the path's ray at the surface and starts it there; it leaves that body. */
    public static void reflect(float[] path, int body) {
        float directionDotNormal = path[Layout.DIRECTION] * path[Layout.NORMAL]
                + path[Layout.DIRECTION + 1] * path[Layout.NORMAL + 1]
                + path[Layout.DIRECTION + 2] * path[Layout.NORMAL + 2];
        float x = path[Layout.DIRECTION] - 2f * directionDotNormal * path[Layout.NORMAL];
        float y = path[Layout.DIRECTION + 1] - 2f * directionDotNormal * path[Layout.NORMAL + 1];
        float z = path[Layout.DIRECTION + 2] - 2f * directionDotNormal * path[Layout.NORMAL + 2];
        float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
        path[Layout.DIRECTION] = x * inverse;
        path[Layout.DIRECTION + 1] = y * inverse;
        path[Layout.DIRECTION + 2] = z * inverse;
        path[Layout.ORIGIN] = path[Layout.POINT];
        path[Layout.ORIGIN + 1] = path[Layout.POINT + 1];
        path[Layout.ORIGIN + 2] = path[Layout.POINT + 2];
        path[Layout.LEAVING] = body;
    }
}
