package dev.twister.kernel;

/** What Whitted's tree adds to {@link LightLayers}. */
final class WhittedLayers {
    private WhittedLayers() {}

    /**
     * Adds what the surface reflects of a light.
     *
     * @param light its body
     * @param part what it adds to lit
     * @param visible S in [0, 1]
     */
    static void shade(
            float[] path,
            float[] scratch,
            int light,
            float part,
            float visible,
            float[] frame,
            float[] looks,
            int variant) {
        if (Views.isLayered(variant) != 0) {
            int at = LightLayers.place(light, frame, looks);
            float specular = Illumination.highlight(path, visible);
            float matte = matte(path, frame, variant) * part;
            for (int channel = 0; channel < 3; channel++) {
                float color = looks[Layout.LOOK_STRIDE * light + channel];
                scratch[at + channel] = scratch[at + channel]
                        + path[Layout.THROUGHPUT + channel]
                                * (Scatter.tint(path, channel, variant) * color * specular
                                        + matte * path[Layout.ALBEDO + channel]);
            }
        }
    }

    /**
     * Adds what the surface reflects of ambient light.
     *
     * @param part of lit beyond the sum of the lights' parts
     */
    static void ambient(float[] path, float[] scratch, float part, float[] frame, float[] looks, int variant) {
        if (Views.isLayered(variant) != 0) {
            int at = LightLayers.place(Layout.PLANE, frame, looks);
            float matte = matte(path, frame, variant) * part;
            for (int channel = 0; channel < 3; channel++) {
                scratch[at + channel] = scratch[at + channel]
                        + path[Layout.THROUGHPUT + channel] * matte * path[Layout.ALBEDO + channel];
            }
        }
    }

    /** Adds what the surface reflects of the only light and of ambient light. */
    static void shade(
            float[] path, float[] scratch, float visible, float lit, float[] frame, float[] looks, int variant) {
        if (Views.isLayered(variant) != 0) {
            float part = Math.max(0f, path[Layout.NORMAL_DOT_LIGHT]) * visible;
            shade(path, scratch, Layout.LIGHT, part, visible, frame, looks, variant);
            ambient(path, scratch, lit - part, frame, looks, variant);
        }
    }

    private static float matte(float[] path, float[] frame, int variant) {
        return (1f - Path.mirror(path, frame)) * (1f - Path.transmission(path, frame, variant));
    }

    /** Adds the color of a light at which the path ends. */
    static void meet(float[] path, float[] scratch, int light, float[] frame, float[] looks, int variant) {
        if (Views.isLayered(variant) != 0) {
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.EMITTED + channel] = looks[Layout.LOOK_STRIDE * light + channel];
            }
            LightLayers.add(path, scratch, light, 1f, frame, looks, variant);
        }
    }

    /** Adds the light that the surface emits. */
    static void emit(float[] path, float[] scratch, int body, float[] frame, float[] looks, int variant) {
        int layered = Views.isLayered(variant) & ((variant & Variant.MATERIALS) != 0 ? 1 : 0);
        if (layered != 0) {
            if (Emitter.shines(path, body, frame, looks, variant) != 0) {
                for (int channel = 0; channel < 3; channel++) {
                    path[Layout.EMITTED + channel] = Emitter.emission(path, body, channel, looks, variant);
                }
                LightLayers.add(path, scratch, body, 1f, frame, looks, variant);
            }
        }
    }
}
