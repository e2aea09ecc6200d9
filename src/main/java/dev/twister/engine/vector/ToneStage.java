package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import dev.twister.kernel.ToneMapping;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;

/** From a tile's linear colours to 8-bit ARGB: {@link ToneMapping}. */
final class ToneStage {
    private static final float BRIGHTEST = 65504f;
    private static final float SRGB_LINEAR_END = 0.0031308f;
    private static final int OPAQUE = 0xFF000000;

    private ToneStage() {}

    /** Maps the sums of so many samples to [0, 1] and above. */
    static void map(Tile tile, float[] properties, int samples) {
        float scale = properties[Layout.EXPOSURE_SCALE] / samples;
        int operator = (int) properties[Layout.TONE_MAP];
        for (int column = Tile.RED; column <= Tile.BLUE; column += Tile.SIZE) {
            expose(tile.values, column, scale);
            if (operator == ToneMapping.REINHARD) {
                reinhard(tile.values, column);
            }
            if (operator == ToneMapping.ACES) {
                aces(tile.values, column);
            }
            if (properties[Layout.SRGB] > 0f) {
                srgb(tile.values, column);
            }
        }
    }

    private static void expose(float[] t, int column, float scale) {
        for (int at = column; at < column + Tile.SIZE; at += Lanes.COUNT) {
            FloatVector exposed = Lanes.larger(Lanes.load(t, at).mul(scale), Lanes.all(0f));
            Lanes.smaller(exposed, Lanes.all(BRIGHTEST)).intoArray(t, at);
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
            FloatVector above = c.mul(2.51f).add(0.03f).mul(c);
            FloatVector below = c.mul(2.43f).add(0.59f).mul(c).add(0.14f);
            above.div(below).intoArray(t, at);
        }
    }

    private static void srgb(float[] t, int column) {
        for (int at = column; at < column + Tile.SIZE; at += Lanes.COUNT) {
            FloatVector linear = Lanes.smaller(Lanes.load(t, at), Lanes.all(1f));
            FloatVector x = linear.sqrt().sqrt().sqrt();
            FloatVector polynomial = Lanes.all(0.012356257f);
            polynomial = Lanes.fma(polynomial, x, Lanes.all(-0.08731597f));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(0.3976099f));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(0.76444095f));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(-0.10223673f));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(0.016488077f));
            polynomial = Lanes.fma(polynomial, x, Lanes.all(-0.0013424668f));
            FloatVector curved = polynomial.mul(1.055f).sub(0.055f);
            linear.mul(12.92f)
                    .blend(curved, linear.compare(VectorOperators.GT, SRGB_LINEAR_END))
                    .intoArray(t, at);
        }
    }

    /** Packs the mapped channels. */
    static void pack(Tile tile) {
        float[] t = tile.values;
        for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
            IntVector red = quantized(t, at + Tile.RED);
            IntVector green = quantized(t, at + Tile.GREEN);
            IntVector blue = quantized(t, at + Tile.BLUE);
            red.lanewise(VectorOperators.LSHL, 16)
                    .or(green.lanewise(VectorOperators.LSHL, 8))
                    .or(blue)
                    .or(OPAQUE)
                    .intoArray(tile.argb, at);
        }
    }

    private static IntVector quantized(float[] t, int at) {
        FloatVector shown = Lanes.smaller(Lanes.load(t, at), Lanes.all(1f));
        return Lanes.truncated(shown.mul(255f).add(0.5f));
    }
}
