package dev.twister.engine.vector.step;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.KernelMath;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** From a tile's linear colors to 8-bit ARGB: {@link Tone}. */
public final class ToneLanes {
    /**
     * Adding it to a number up to 255 leaves the rounded integer in the lowest byte; all other bits set are in the
     * highest byte.
     */
    private static final float ROUNDER = 0x1p23f;

    private ToneLanes() {}

    /** Tone maps the sums of {@code samples} samples, unless only exposure and clamping are required. */
    static void map(Tile tile, float[] values, int samples) {
        if (!isPlain(values)) {
            mapAll(tile, values, values[Layout.EXPOSURE_SCALE] / samples);
        }
    }

    private static boolean isPlain(float[] values) {
        return (int) values[Layout.TONE_MAP] == Tone.CLAMP && values[Layout.SRGB] <= 0f;
    }

    private static void mapAll(Tile tile, float[] values, float scale) {
        int operator = (int) values[Layout.TONE_MAP];
        for (int column = Tile.RED; column <= Tile.BLUE; column += Tile.SIZE) {
            expose(tile.values, column, scale);
            if (operator == Tone.REINHARD) {
                reinhard(tile.values, column);
            }
            if (operator == Tone.ACES) {
                aces(tile.values, column);
            }
            if (values[Layout.SRGB] > 0f) {
                srgb(tile.values, column);
            }
        }
    }

    private static void expose(float[] t, int column, float scale) {
        for (int at = column; at < column + Tile.SIZE; at += Lanes.COUNT) {
            FloatVector exposed = Lanes.larger(Lanes.load(t, at).mul(scale), Lanes.all(0f));
            Lanes.smaller(exposed, Lanes.all(Tone.BRIGHTEST)).intoArray(t, at);
        }
    }

    private static void reinhard(float[] t, int column) {
        for (int at = column; at < column + Tile.SIZE; at += Lanes.COUNT) {
            FloatVector c = Lanes.load(t, at);
            c.div(c.add(1f)).intoArray(t, at);
        }
    }

    private static void aces(float[] t, int column) {
        for (int at = column; at < column + Tile.SIZE; at += Lanes.COUNT) {
            FloatVector c = Lanes.load(t, at);
            FloatVector above =
                    c.mul(Tone.ACES_TOP_SQUARE).add(Tone.ACES_TOP_LINE).mul(c);
            FloatVector below = c.mul(Tone.ACES_BOTTOM_SQUARE)
                    .add(Tone.ACES_BOTTOM_LINE)
                    .mul(c)
                    .add(Tone.ACES_BOTTOM);
            above.div(below).intoArray(t, at);
        }
    }

    private static void srgb(float[] t, int column) {
        for (int at = column; at < column + Tile.SIZE; at += Lanes.COUNT) {
            FloatVector linear = Lanes.smaller(Lanes.load(t, at), Lanes.all(1f));
            FloatVector x = linear.sqrt().sqrt().sqrt();
            FloatVector polynomial = Lanes.all(KernelMath.TEN_THIRDS_6);
            polynomial = Lanes.fma(polynomial, x, Lanes.all(KernelMath.TEN_THIRDS_5));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(KernelMath.TEN_THIRDS_4));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(KernelMath.TEN_THIRDS_3));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(KernelMath.TEN_THIRDS_2));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(KernelMath.TEN_THIRDS_1));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(KernelMath.TEN_THIRDS_0));
            FloatVector curved = polynomial.mul(Tone.SRGB_SCALE).sub(Tone.SRGB_OFFSET);
            linear.mul(Tone.SRGB_SLOPE)
                    .blend(curved, linear.compare(VectorOperators.GT, Tone.SRGB_LINEAR_END))
                    .intoArray(t, at);
        }
    }

    /**
     * Packs the channels, which are tone mapped or only summed. Where rounding moves a channel across the midpoint of
     * two integers, it differs by 1 from {@link Tone#quantized}.
     */
    static void pack(Tile tile, float[] values, int samples) {
        float scale = isPlain(values) ? values[Layout.EXPOSURE_SCALE] / samples : 1f;
        float whole = 255f * scale;
        float brightest = 1f / scale;
        float[] t = tile.values;
        for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
            FloatVector red = Lanes.larger(Lanes.load(t, at + Tile.RED), Lanes.all(0f));
            FloatVector green = Lanes.larger(Lanes.load(t, at + Tile.GREEN), Lanes.all(0f));
            FloatVector blue = Lanes.larger(Lanes.load(t, at + Tile.BLUE), Lanes.all(0f));
            red = Lanes.fma(Lanes.smaller(red, Lanes.all(brightest)), whole, ROUNDER);
            green = Lanes.fma(Lanes.smaller(green, Lanes.all(brightest)), whole, ROUNDER);
            blue = Lanes.fma(Lanes.smaller(blue, Lanes.all(brightest)), whole, ROUNDER);
            red.reinterpretAsInts()
                    .lanewise(VectorOperators.LSHL, 16)
                    .or(green.reinterpretAsInts().lanewise(VectorOperators.LSHL, 8))
                    .or(blue.reinterpretAsInts())
                    .or(Tone.OPAQUE)
                    .intoArray(tile.argb, Lanes.BORDER + at);
        }
    }
}
