package dev.twister.oracle;

import dev.twister.scene.Rendering;

/** Converts linear colors to pixels. */
final class OracleTone {
    private final Rendering settings;

    OracleTone(Rendering settings) {
        this.settings = settings;
    }

    /** Returns a color as 0xAARRGGBB. */
    int argb(Color linear) {
        return 0xFF000000 | quantized(linear.red()) << 16 | quantized(linear.green()) << 8 | quantized(linear.blue());
    }

    private int quantized(double linear) {
        double mapped = Math.clamp(toneMapped(linear * Math.pow(2, settings.exposure())), 0, 1);
        return (int) Math.round(255 * (settings.srgb() ? srgbEncoded(mapped) : mapped));
    }

    private double toneMapped(double c) {
        return switch (settings.toneMap()) {
            case CLAMP -> c;
            case REINHARD -> c / (1 + c);
            case ACES -> (2.51 * c + 0.03) * c / ((2.43 * c + 0.59) * c + 0.14);
        };
    }

    /** The sRGB transfer function of IEC 61966-2-1. */
    private static double srgbEncoded(double c) {
        return c <= 0.0031308 ? 12.92 * c : 1.055 * Math.pow(c, 1 / 2.4) - 0.055;
    }
}
