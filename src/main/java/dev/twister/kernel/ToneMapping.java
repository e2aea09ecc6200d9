package dev.twister.kernel;

/** From linear colour, exposure applied, to what a pixel shows. */
public final class ToneMapping {
    public static final int CLAMP = 0;
    public static final int REINHARD = 1;
    public static final int ACES = 2;

    /** Far above white on every curve, and far from overflow when squared. */
    private static final float BRIGHTEST = 65504f;

    private static final float SRGB_LINEAR_END = 0.0031308f;

    private ToneMapping() {}

    /** 0 to 255 for one channel of linear radiance. */
    public static int quantized(float radiance, float exposureScale, int operator, float srgb) {
        float scaled = radiance * exposureScale;
        float exposed = scaled > 0f ? (scaled < BRIGHTEST ? scaled : BRIGHTEST) : 0f;
        float operated = operated(exposed, operator);
        float mapped = operated < 1f ? operated : 1f;
        float shown = srgb > 0f ? srgbEncoded(mapped) : mapped;
        return (int) (shown * 255f + 0.5f);
    }

    private static float operated(float c, int operator) {
        float result = c;
        if (operator == REINHARD) {
            result = c / (1f + c);
        }
        if (operator == ACES) {
            result = c * (2.51f * c + 0.03f) / (c * (2.43f * c + 0.59f) + 0.14f);
        }
        return result;
    }

    /** IEC 61966-2-1's curve for a channel in [0, 1], within 2e-6. */
    public static float srgbEncoded(float linear) {
        float encoded = 12.92f * linear;
        if (linear > SRGB_LINEAR_END) {
            float eighthRoot = (float) Math.sqrt(Math.sqrt(Math.sqrt(linear)));
            encoded = 1.055f * KernelMath.tenThirdsPower(eighthRoot) - 0.055f;
        }
        return encoded;
    }
}
