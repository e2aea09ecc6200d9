package dev.twister.gui.property;

import dev.twister.kernel.Tone;
import dev.twister.scene.Rgb;
import java.util.function.DoubleUnaryOperator;

/** Linear colors as a picture at exposure 0 shows them, each channel in [0, 1], and back. */
public final class ScreenColor {
    private static final double GAMMA = 2.4;

    private ScreenColor() {}

    /**
     * What a screen shows of a linear color.
     *
     * @param srgb whether the picture has the sRGB curve
     */
    public static Rgb shown(Rgb linear, boolean srgb) {
        return mapped(linear, srgb ? ScreenColor::encoded : channel -> channel);
    }

    /** The linear color that a screen shows so. */
    public static Rgb linear(Rgb shown, boolean srgb) {
        return mapped(shown, srgb ? ScreenColor::decoded : channel -> channel);
    }

    private static Rgb mapped(Rgb color, DoubleUnaryOperator curve) {
        return new Rgb(mapped(color.red(), curve), mapped(color.green(), curve), mapped(color.blue(), curve));
    }

    private static double mapped(double channel, DoubleUnaryOperator curve) {
        return Math.clamp(curve.applyAsDouble(Math.clamp(channel, 0, 1)), 0, 1);
    }

    private static double encoded(double linear) {
        return linear <= Tone.SRGB_LINEAR_END
                ? linear * Tone.SRGB_SLOPE
                : Tone.SRGB_SCALE * Math.pow(linear, 1 / GAMMA) - Tone.SRGB_OFFSET;
    }

    private static double decoded(double shown) {
        return shown <= Tone.SRGB_LINEAR_END * Tone.SRGB_SLOPE
                ? shown / Tone.SRGB_SLOPE
                : Math.pow((shown + Tone.SRGB_OFFSET) / Tone.SRGB_SCALE, GAMMA);
    }
}
