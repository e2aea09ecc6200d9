package dev.twister.sky.image;

import java.util.Optional;
import java.util.function.DoubleUnaryOperator;

/**
 * Samples that a curve makes linear, of given primaries.
 *
 * @param curve from encoded to linear, 0 to 1 each
 * @param primaries those of the linear channels
 */
public record CurveEncoding(DoubleUnaryOperator curve, Primaries primaries) implements ColorEncoding {
    /** What images are that do not say what they are (IEC 61966-2-1). */
    public static final CurveEncoding SRGB = new CurveEncoding(CurveEncoding::linear, Primaries.SRGB);

    /** Linear intensity, 0 to 1, of an sRGB value of 0 to 1. */
    public static double linear(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    /** The linear value of every sample from 0 to the largest. */
    public float[] table(int largest) {
        float[] table = new float[largest + 1];
        for (int value = 0; value <= largest; value++) {
            table[value] = (float) curve.applyAsDouble((double) value / largest);
        }
        return table;
    }

    @Override
    public ColorRows rows(int width, int channels, int largest) {
        float[] table = table(largest);
        if (channels == 1) {
            int[] values = new int[3 * width];
            return new ColorRows(samples -> spread(samples, values), table, Optional.empty());
        }
        return new ColorRows(
                samples -> samples,
                table,
                primaries.near(Primaries.SRGB) ? Optional.empty() : Optional.of(primaries.toSrgb()));
    }

    private static int[] spread(int[] gray, int[] values) {
        for (int i = 0; i < values.length; i++) {
            values[i] = gray[i / 3];
        }
        return values;
    }
}
