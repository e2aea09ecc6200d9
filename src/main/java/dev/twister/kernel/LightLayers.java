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
        if (Views.isLayered(variant) != 0) {
            int end = Layout.SCRATCH_LAYERS + 3 * (int) frame[Layout.LIGHT_LAYERS];
            for (int i = Layout.SCRATCH_LAYERS; i < end; i++) {
                scratch[i] = 0f;
            }
        }
    }

    /** Place in the scratch of a body's layer; {@link Layout#NOTHING} for the sky's. */
    static int place(int body, float[] frame, float[] looks) {
        return Layout.SCRATCH_LAYERS + 3 * (int) looks[(int) frame[Layout.LIGHT_GROUPS] + 1 + body];
    }

    /** In path tracing: the emitter of the next {@link #addDirect} is chosen. */
    static void choose(float[] path, int body, float[] frame, float[] looks, int variant) {
        if (Views.isLayered(variant) != 0) {
            path[Layout.EMITTER_LAYER] = place(body, frame, looks);
        }
    }

    /** Adds the light that a ray to an emitter has found, as {@link PathTracer} does. */
    static void addDirect(float[] path, float[] scratch, float visible, int variant) {
        if (Views.isLayered(variant) != 0) {
            int at = (int) path[Layout.EMITTER_LAYER];
            for (int channel = 0; channel < 3; channel++) {
                scratch[at + channel] = scratch[at + channel] + visible * path[Layout.DIRECT + channel];
            }
        }
    }

    /** Adds what the path's ray has met: {@link Layout#EMITTED} times throughput and weight. */
    static void add(float[] path, float[] scratch, int body, float weight, float[] frame, float[] looks, int variant) {
        if (Views.isLayered(variant) != 0) {
            int at = place(body, frame, looks);
            for (int channel = 0; channel < 3; channel++) {
                scratch[at + channel] = scratch[at + channel]
                        + path[Layout.THROUGHPUT + channel] * weight * path[Layout.EMITTED + channel];
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
        if (Views.isLayered(variant) != 0) {
            int count = (int) frame[Layout.LIGHT_LAYERS];
            for (int layer = 0; layer < count; layer++) {
                for (int i = 0; i < 3; i++) {
                    layers[first + layer * plane + i] = scratch[Layout.SCRATCH_LAYERS + 3 * layer + i] * average;
                }
            }
        }
    }
}
