package dev.twister.kernel;

/** Reflected light of a surface, and the reflected ray of a plain one. */
public final class Scatter {
    private Scatter() {}

    /**
     * Adds {@code T * (tint * lightColor * spec + (1 - m) * (1 - t) * C * lit)} to the radiance, with the throughput T.
     * With several lights {@code lightColor * spec} is the sum of {@link SeveralLights#shade}.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param visible S in [0, 1]
     * @param mirror m in [0, 1]
     * @param transmission t in [0, 1]
     * @param lit result of {@link Illumination#lit} or {@link SeveralLights#shade}
     * @param looks {@link Layout#LOOK_STRIDE} floats per body
     */
    public static void shade(
            float[] path, float visible, float mirror, float transmission, float lit, float[] looks, int variant) {
        float specular = 1f;
        if ((variant & Variant.LIGHTS) == 0) {
            specular = Illumination.highlight(path, visible);
        }
        float matte = (1f - mirror) * (1f - transmission) * lit;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.RADIANCE + channel] = path[Layout.RADIANCE + channel]
                    + path[Layout.THROUGHPUT + channel]
                            * (tint(path, channel, variant) * highlight(path, channel, looks, variant) * specular
                                    + matte * path[Layout.ALBEDO + channel]);
        }
    }

    /** Color of the only light's highlights, or the sum of all lights' highlights. */
    static float highlight(float[] path, int channel, float[] looks, int variant) {
        float color = looks[Layout.LOOK_STRIDE * Layout.LIGHT + channel];
        if ((variant & Variant.LIGHTS) != 0) {
            color = path[Layout.HIGHLIGHT + channel];
        }
        return color;
    }

    /** {@code 1 + M * (C - 1)} of a channel: what a metal's reflections are multiplied by. */
    static float tint(float[] path, int channel, int variant) {
        float tint = 1f;
        if ((variant & Variant.MATERIALS) != 0) {
            tint = 1f + path[Layout.METALLIC] * (path[Layout.ALBEDO + channel] - 1f);
        }
        return tint;
    }

    /** Adds the light that the surface emits. */
    static void emit(float[] path, int body, float[] frame, float[] looks, int variant) {
        if (Emitter.shines(path, body, frame, looks, variant) != 0) {
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.RADIANCE + channel] = path[Layout.RADIANCE + channel]
                        + path[Layout.THROUGHPUT + channel] * Emitter.emission(path, body, channel, looks, variant);
            }
        }
    }

    /**
     * Reflects the path's ray at the surface, from which it starts.
     *
     * @param reflected {@code m * lit}, the factor for the throughput
     */
    public static void reflect(float[] path, int body, float reflected) {
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
        for (int i = 0; i < 3; i++) {
            path[Layout.ORIGIN + i] = path[Layout.POINT + i];
            path[Layout.THROUGHPUT + i] = path[Layout.THROUGHPUT + i] * reflected;
        }
        path[Layout.LEAVING] = body;
    }
}
