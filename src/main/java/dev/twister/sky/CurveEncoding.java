package dev.twister.sky;

import java.util.function.DoubleUnaryOperator;

/**
 * Samples that a curve makes linear, of given primaries.
 *
 * @param curve from encoded to linear, 0 to 1 each
 * @param primaries those of the linear channels
 */
record CurveEncoding(DoubleUnaryOperator curve, Primaries primaries) implements ColorEncoding {
    /** What images are that do not say what they are (IEC 61966-2-1). */
    static final CurveEncoding SRGB = new CurveEncoding(CurveEncoding::linear, Primaries.SRGB);

    /** Linear intensity, 0 to 1, of an sRGB value of 0 to 1. */
    static double linear(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    /** The linear value of every sample from 0 to the largest. */
    float[] table(int largest) {
        float[] table = new float[largest + 1];
        for (int value = 0; value <= largest; value++) {
            table[value] = (float) curve.applyAsDouble((double) value / largest);
        }
        return table;
    }

    @Override
    public Rows rows(int width, int channels, int largest) {
        float[] table = table(largest);
        if (channels == 1) {
            return (samples, linear) -> gray(table, samples, linear);
        }
        if (primaries.near(Primaries.SRGB)) {
            return (samples, linear) -> look(table, samples, linear);
        }
        double[][] matrix = primaries.toSrgb();
        return (samples, linear) -> {
            look(table, samples, linear);
            convert(matrix, linear);
        };
    }

    private static void gray(float[] table, int[] samples, float[] linear) {
        for (int i = 0; i < linear.length; i++) {
            linear[i] = table[samples[i / 3]];
        }
    }

    private static void look(float[] table, int[] samples, float[] linear) {
        for (int i = 0; i < linear.length; i++) {
            linear[i] = table[samples[i]];
        }
    }

    private static void convert(double[][] matrix, float[] linear) {
        for (int at = 0; at < linear.length; at += 3) {
            float red = linear[at];
            float green = linear[at + 1];
            float blue = linear[at + 2];
            for (int channel = 0; channel < 3; channel++) {
                double[] row = matrix[channel];
                linear[at + channel] = (float) Math.clamp(row[0] * red + row[1] * green + row[2] * blue, 0, 1);
            }
        }
    }
}
