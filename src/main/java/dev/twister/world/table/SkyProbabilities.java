package dev.twister.world.table;

/** The probabilities with which path tracing chooses the sky's directions, as {@code kernel.SkyTable} reads them. */
final class SkyProbabilities {
    private static final double RED = 0.2126;
    private static final double GREEN = 0.7152;
    private static final double BLUE = 0.0722;

    private SkyProbabilities() {}

    /**
     * The table: {@code height} sums of the rows' probabilities from the top, then for each row {@code width} sums of
     * its texels', all in proportion to mean luminance times solid angle.
     *
     * @param texels three floats per texel: linear radiance, row by row from the top
     * @return {@code float[height + width * height]}; empty if the sky is black
     */
    static float[] of(float[] texels, int width, int height) {
        double[] rows = new double[height];
        float[] table = new float[height + width * height];
        double total = 0;
        double[] weights = new double[width];
        for (int row = 0; row < height; row++) {
            // The solid angle of a row's texels is proportional to the difference of the sines of its edges.
            double solidAngle = Math.cos(Math.PI * row / height) - Math.cos(Math.PI * (row + 1) / height);
            for (int column = 0; column < width; column++) {
                weights[column] = luminance(texels, width, height, column, row);
            }
            rows[row] = solidAngle * sums(weights, table, height + width * row);
            total += rows[row];
        }
        if (!(total > 0)) {
            return new float[0];
        }
        sums(rows, table, 0);
        return table;
    }

    /** Writes the sums relative to the total, which it returns. The last that is reached is exactly 1. */
    private static double sums(double[] weights, float[] table, int start) {
        double total = 0;
        for (double weight : weights) {
            total += weight;
        }
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            sum += weights[i];
            table[start + i] = total > 0 ? (float) Math.min(sum / total, 1) : 1;
        }
        for (int i = weights.length - 1; i >= 0 && (i == weights.length - 1 || weights[i + 1] == 0); i--) {
            table[start + i] = 1;
        }
        return total;
    }

    /** The mean of the bilinear interpolation over a texel, which has parts of its neighbors. */
    private static double luminance(float[] texels, int width, int height, int column, int row) {
        int left = (column + width - 1) % width;
        int right = (column + 1) % width;
        return 0.75 * across(texels, width, left, column, right, row)
                + 0.125 * across(texels, width, left, column, right, Math.max(row - 1, 0))
                + 0.125 * across(texels, width, left, column, right, Math.min(row + 1, height - 1));
    }

    private static double across(float[] texels, int width, int left, int column, int right, int row) {
        return 0.75 * luminance(texels, 3 * (width * row + column))
                + 0.125 * (luminance(texels, 3 * (width * row + left)) + luminance(texels, 3 * (width * row + right)));
    }

    static double luminance(float[] colors, int at) {
        return RED * colors[at] + GREEN * colors[at + 1] + BLUE * colors[at + 2];
    }
}
