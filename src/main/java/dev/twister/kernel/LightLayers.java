package dev.twister.kernel;

/**
 * Light of each group of lights, along with the picture. Each light that the path adds to the picture is added to one
 * layer, too, so that the sum of the layers is the picture. Their sums over the samples are in the scratch. What has no
 * layers has none of this code.
 *
 * <p>At {@link Layout#LIGHT_GROUPS} in {@code looks} is the layer of the sky, then of each body; the plane's is that of
 * ambient light.
 */
public final class LightLayers {
    private LightLayers() {}

    /** Resets the sums of a pixel. */
    static void start(float[] scratch, float[] frame, int variant) {
        if (Aspect.isLayered(variant) != 0) {
            int end = Layout.SCRATCH_LAYERS + 3 * (int) frame[Layout.LIGHT_LAYERS];
            for (int i = Layout.SCRATCH_LAYERS; i < end; i++) {
                scratch[i] = 0f;
            }
        }
    }

    /** Place in the scratch of a body's layer; {@link Layout#NOTHING} for the sky's. */
    private static int place(int body, float[] frame, float[] looks) {
        return Layout.SCRATCH_LAYERS + 3 * (int) looks[(int) frame[Layout.LIGHT_GROUPS] + 1 + body];
    }

    /** In path tracing: the emitter of the next {@link #addDirect} is chosen. */
    static void choose(float[] path, int body, float[] frame, float[] looks, int variant) {
        if (Aspect.isLayered(variant) != 0) {
            path[Layout.EMITTER_LAYER] = place(body, frame, looks);
        }
    }

    /** Adds the light that a ray to an emitter has found, as {@link PathTracer} does. */
    static void addDirect(float[] path, float[] scratch, float visible, int variant) {
        if (Aspect.isLayered(variant) != 0) {
            int at = (int) path[Layout.EMITTER_LAYER];
            for (int channel = 0; channel < 3; channel++) {
                scratch[at + channel] = scratch[at + channel] + visible * path[Layout.DIRECT + channel];
            }
        }
    }

    /**
     * Adds what the path's ray has met: {@link Layout#EMITTED} times throughput and weight.
     *
     * @param most limit of each channel; 0 for none
     */
    static void add(
            float[] path,
            float[] scratch,
            int body,
            float weight,
            float most,
            float[] frame,
            float[] looks,
            int variant) {
        if (Aspect.isLayered(variant) != 0) {
            int at = place(body, frame, looks);
            for (int channel = 0; channel < 3; channel++) {
                float found = path[Layout.THROUGHPUT + channel] * weight * path[Layout.EMITTED + channel];
                scratch[at + channel] = scratch[at + channel] + (most > 0f ? Math.min(found, most) : found);
            }
        }
    }

    /**
     * Without path tracing: adds what the surface reflects of a light.
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
        if (Aspect.isLayered(variant) != 0) {
            int at = place(light, frame, looks);
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
     * Without path tracing: adds what the surface reflects of ambient light.
     *
     * @param part of lit beyond the sum of the lights' parts
     */
    static void ambient(float[] path, float[] scratch, float part, float[] frame, float[] looks, int variant) {
        if (Aspect.isLayered(variant) != 0) {
            int at = place(Layout.PLANE, frame, looks);
            float matte = matte(path, frame, variant) * part;
            for (int channel = 0; channel < 3; channel++) {
                scratch[at + channel] = scratch[at + channel]
                        + path[Layout.THROUGHPUT + channel] * matte * path[Layout.ALBEDO + channel];
            }
        }
    }

    /** Without path tracing: adds what the surface reflects of the only light and of ambient light. */
    static void shade(
            float[] path, float[] scratch, float visible, float lit, float[] frame, float[] looks, int variant) {
        if (Aspect.isLayered(variant) != 0) {
            float part = Math.max(0f, path[Layout.NORMAL_DOT_LIGHT]) * visible;
            shade(path, scratch, Layout.LIGHT, part, visible, frame, looks, variant);
            ambient(path, scratch, lit - part, frame, looks, variant);
        }
    }

    private static float matte(float[] path, float[] frame, int variant) {
        return (1f - Path.mirror(path, frame)) * (1f - Path.transmission(path, frame, variant));
    }

    /** Without path tracing: adds the color of a light at which the path ends. */
    static void meet(float[] path, float[] scratch, int light, float[] frame, float[] looks, int variant) {
        if (Aspect.isLayered(variant) != 0) {
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.EMITTED + channel] = looks[Layout.LOOK_STRIDE * light + channel];
            }
            add(path, scratch, light, 1f, 0f, frame, looks, variant);
        }
    }

    /** Without path tracing: adds the light that the surface emits. */
    static void emit(float[] path, float[] scratch, int body, float[] frame, float[] looks, int variant) {
        int layered = Aspect.isLayered(variant) & ((variant & Variant.MATERIALS) != 0 ? 1 : 0);
        if (layered != 0) {
            if (Emitter.shines(path, body, frame, looks, variant) != 0) {
                for (int channel = 0; channel < 3; channel++) {
                    path[Layout.EMITTED + channel] = Emitter.emission(path, body, channel, looks, variant);
                }
                add(path, scratch, body, 1f, 0f, frame, looks, variant);
            }
        }
    }

    /**
     * Stores the means of a pixel's samples.
     *
     * @param layers planes of three floats per pixel
     * @param first place of the first plane
     * @param plane length of a plane
     * @param average 1 / number of samples
     */
    static void store(
            float[] layers, int first, int plane, float[] scratch, float average, float[] frame, int variant) {
        if (Aspect.isLayered(variant) != 0) {
            int count = (int) frame[Layout.LIGHT_LAYERS];
            for (int layer = 0; layer < count; layer++) {
                for (int i = 0; i < 3; i++) {
                    layers[first + layer * plane + i] = scratch[Layout.SCRATCH_LAYERS + 3 * layer + i] * average;
                }
            }
        }
    }
}
