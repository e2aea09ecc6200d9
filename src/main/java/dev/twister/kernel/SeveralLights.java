package dev.twister.kernel;

/** Illumination by all lights: {@code lit = max(a, sum k * max(0, N.L) * S)}, and the sum of their highlights. */
public final class SeveralLights {
    private SeveralLights() {}

    /** A light's body. */
    private static int at(int index, float[] frame, float[] looks) {
        return (int) looks[(int) frame[Layout.LIGHT_TABLE] + index];
    }

    /**
     * Lets a light shade: writes its body, and its direction from {@link Layout#POINT} as {@link Illumination#aim}.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     */
    public static void choose(float[] path, int light, float[] bodies, float[] looks) {
        path[Layout.SHADING_LIGHT] = light;
        Illumination.aimAtAny(path, light, bodies, looks);
    }

    /**
     * Writes the sum of the highlights ({@link Layout#HIGHLIGHT}) of the surface that the ray has hit.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, after {@link Path#meet}
     * @param shadowed 1, or 0 for S = 1
     * @return lit in [0, 1] or more
     */
    static float shade(
            float[] path,
            int body,
            int shadowed,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float sum = 0f;
        path[Layout.HIGHLIGHT] = 0f;
        path[Layout.HIGHLIGHT + 1] = 0f;
        path[Layout.HIGHLIGHT + 2] = 0f;
        int count = (int) frame[Layout.LIGHTS];
        for (int index = 0; index < count; index++) {
            int light = at(index, frame, looks);
            choose(path, light, bodies, looks);
            float visible = 1f;
            if (shadowed != 0) {
                visible = Path.visible(path, body, scratch, frame, bodies, looks, meshes, variant);
            }
            visible = visible * SpotEmitter.part(path, Layout.TO_LIGHT, light, looks);
            int look = Layout.LOOK_STRIDE * light;
            float part = part(path, light, visible, looks);
            sum = sum + part;
            WhittedLayers.shade(path, scratch, light, part, visible, frame, looks, variant);
            float specular = Illumination.highlight(path, visible);
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.HIGHLIGHT + channel] = path[Layout.HIGHLIGHT + channel] + looks[look + channel] * specular;
            }
        }
        float lit = Math.max(sum, Illumination.ambient(path, frame, variant));
        WhittedLayers.ambient(path, scratch, lit - sum, frame, looks, variant);
        return lit;
    }

    /** What a light adds to lit: {@code k * max(0, N.L) * S}. */
    public static float part(float[] path, int light, float visible, float[] looks) {
        float share = looks[Layout.LOOK_STRIDE * light + Layout.LOOK_SHARE];
        return share * Math.max(0f, path[Layout.NORMAL_DOT_LIGHT]) * visible;
    }

    /** The mean of S over the lights, in [0, 1]. */
    public static float visible(
            float[] path,
            int body,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float sum = 0f;
        int count = (int) frame[Layout.LIGHTS];
        for (int index = 0; index < count; index++) {
            choose(path, at(index, frame, looks), bodies, looks);
            sum = sum + Shadow.visible(path, body, scratch, frame, bodies, looks, meshes, variant);
        }
        return sum / count;
    }
}
