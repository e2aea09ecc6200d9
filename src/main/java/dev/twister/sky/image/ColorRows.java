package dev.twister.sky.image;

import dev.twister.sky.PackedImage;
import java.util.Optional;

/**
 * The conversion of an image's rows to linear light.
 *
 * @param recoding of samples to values of red, green and blue
 * @param table the linear light, 0 to 1, of each value
 * @param toSrgb a matrix for linear light of other primaries
 */
@SuppressWarnings("ArrayRecordComponent") // read in place, for every texel
record ColorRows(Recoding recoding, float[] table, Optional<double[][]> toSrgb) {
    /** The first step of a conversion. */
    interface Recoding {
        /**
         * Values of red, green and blue of each texel of a row, valid until the next call.
         *
         * @param samples of all color channels, texel by texel, each 0 to the largest
         */
        int[] values(int[] samples);
    }

    /** Whether bytes and a table of 256 floats hold all that a row is converted to. */
    boolean fitsBytes() {
        return table.length <= PackedImage.VALUES && toSrgb.isEmpty();
    }

    /**
     * Converts a row.
     *
     * @param samples as for {@link Recoding#values}
     * @param linear receives red, green and blue of each texel, 0 to 1
     */
    void convert(int[] samples, float[] linear) {
        int[] values = recoding.values(samples);
        for (int i = 0; i < linear.length; i++) {
            linear[i] = table[values[i]];
        }
        toSrgb.ifPresent(matrix -> multiply(matrix, linear));
    }

    private static void multiply(double[][] matrix, float[] linear) {
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
