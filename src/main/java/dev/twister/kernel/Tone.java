package dev.twister.kernel;

/** Exposure, tone mapping and encoding of linear color. */
public final class Tone {
    /** Numbers of tone maps, in the order of {@code scene.ToneMap}. */
    public static final int CLAMP = 0;

    public static final int REINHARD = 1;
    public static final int ACES = 2;

    /** Far above white on every curve, and far from overflow when squared. */
    public static final float BRIGHTEST = 65504f;

    /** {@link #ACES}: {@code c (TOP_SQUARE c + TOP_LINE) / (c (BOTTOM_SQUARE c + BOTTOM_LINE) + BOTTOM)}. */
    public static final float ACES_TOP_SQUARE = 2.51f;

    public static final float ACES_TOP_LINE = 0.03f;
    public static final float ACES_BOTTOM_SQUARE = 2.43f;
    public static final float ACES_BOTTOM_LINE = 0.59f;
    public static final float ACES_BOTTOM = 0.14f;

    /** The transfer function of IEC 61966-2-1: linear up to the end, then {@code SCALE c^(1 / 2.4) - OFFSET}. */
    public static final float SRGB_LINEAR_END = 0.0031308f;

    public static final float SRGB_SLOPE = 12.92f;
    public static final float SRGB_SCALE = 1.055f;
    public static final float SRGB_OFFSET = 0.055f;

    /** Alpha bits of an opaque pixel. */
    public static final int OPAQUE = 0xFF000000;

    private Tone() {}

    /**
     * The path's radiance as opaque ARGB.
     *
     * @param average factor for the radiance
     */
    public static int argb(float[] path, float average, float[] frame) {
        int argb = OPAQUE;
        for (int channel = 0; channel < 3; channel++) {
            int level = quantized(
                    path[Layout.RADIANCE + channel] * average,
                    frame[Layout.EXPOSURE_SCALE],
                    (int) frame[Layout.TONE_MAP],
                    frame[Layout.SRGB]);
            argb = argb | (level << (16 - 8 * channel));
        }
        return argb;
    }

    /** The 8-bit value of one channel of linear radiance. */
    public static int quantized(float radiance, float exposureScale, int operator, float srgb) {
        return (int) (shown(radiance, exposureScale, operator, srgb) * 255f + 0.5f);
    }

    /** The display value of one channel of linear radiance, in [0, 1]. */
    public static float shown(float radiance, float exposureScale, int operator, float srgb) {
        float scaled = radiance * exposureScale;
        float exposed = scaled > 0f ? (scaled < BRIGHTEST ? scaled : BRIGHTEST) : 0f;
        float operated = operated(exposed, operator);
        float mapped = operated < 1f ? operated : 1f;
        return srgb > 0f ? srgbEncoded(mapped) : mapped;
    }

    private static float operated(float c, int operator) {
        float result = c;
        if (operator == REINHARD) {
            result = c / (1f + c);
        }
        if (operator == ACES) {
            result = c
                    * (ACES_TOP_SQUARE * c + ACES_TOP_LINE)
                    / (c * (ACES_BOTTOM_SQUARE * c + ACES_BOTTOM_LINE) + ACES_BOTTOM);
        }
        return result;
    }

    /** The transfer function of IEC 61966-2-1 for a channel in [0, 1], within 2e-6. */
    public static float srgbEncoded(float linear) {
        float encoded = SRGB_SLOPE * linear;
        if (linear > SRGB_LINEAR_END) {
            float eighthRoot = (float) Math.sqrt(Math.sqrt(Math.sqrt(linear)));
            encoded = SRGB_SCALE * KernelMath.tenThirdsPower(eighthRoot) - SRGB_OFFSET;
        }
        return encoded;
    }
}
