package dev.twister.scene;

/** The curve of colors that are stored as a screen shows them (IEC 61966-2-1). */
public final class SrgbCurve {
    private SrgbCurve() {}

    /** The linear value of an sRGB value; values outside [0, 1] are clamped. */
    public static double linear(double encoded) {
        double value = Math.clamp(encoded, 0.0, 1.0);
        return value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4);
    }
}
