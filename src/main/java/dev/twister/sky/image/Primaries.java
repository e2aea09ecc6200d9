package dev.twister.sky.image;

import java.util.Arrays;

/**
 * The chromaticities of the red, green and blue that a picture's channels stand for, and of its white.
 *
 * @param red CIE x and y
 * @param green CIE x and y
 * @param blue CIE x and y
 * @param white CIE x and y
 */
@SuppressWarnings("ArrayRecordComponent") // pairs that nobody compares or changes
public record Primaries(double[] red, double[] green, double[] blue, double[] white) {
    /** IEC 61966-2-1, the same as ITU-R BT.709. */
    public static final Primaries SRGB = of(0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290);

    /** Coordinates so close are the same ones, rounded. */
    private static final double ROUNDING = 0.002;

    /** To the responses of the eye's cones, sharpened (Lam 1985, "Bradford"), in which whites are adapted. */
    private static final double[][] CONES = {
        {0.8951, 0.2664, -0.1614},
        {-0.7502, 1.7135, 0.0367},
        {0.0389, -0.0685, 1.0296}
    };

    /** From x and y of red, green, blue and white, in this order. */
    public static Primaries of(double... xy) {
        return new Primaries(
                new double[] {xy[0], xy[1]}, new double[] {xy[2], xy[3]}, new double[] {xy[4], xy[5]}, new double[] {
                    xy[6], xy[7]
                });
    }

    /** Whether these can be a picture's: the white is a mixture of all three. */
    public boolean makeSense() {
        if (!(white[1] > 0)) {
            return false;
        }
        for (double part : whiteParts()) {
            // Written so that NaN fails too.
            if (!(part > 0 && part < 1e3)) {
                return false;
            }
        }
        return true;
    }

    /** Whether these are the same, rounding aside. */
    public boolean near(Primaries other) {
        return near(red, other.red) && near(green, other.green) && near(blue, other.blue) && near(white, other.white);
    }

    /**
     * The matrix that takes linear channels to linear sRGB, with white staying white; for primaries that make sense.
     */
    public double[][] toSrgb() {
        return product(inverse(SRGB.toXyz()), product(adaptation(), toXyz()));
    }

    private static boolean near(double[] one, double[] other) {
        return Math.abs(one[0] - other[0]) <= ROUNDING && Math.abs(one[1] - other[1]) <= ROUNDING;
    }

    private double[][] toXyz() {
        double[] parts = whiteParts();
        double[][] matrix = columns(red, green, blue);
        for (double[] row : matrix) {
            for (int channel = 0; channel < 3; channel++) {
                row[channel] *= parts[channel];
            }
        }
        return matrix;
    }

    /** How much of each primary makes the white of luminance 1. */
    private double[] whiteParts() {
        return times(inverse(columns(red, green, blue)), whiteXyz());
    }

    private double[] whiteXyz() {
        return new double[] {white[0] / white[1], 1, (1 - white[0] - white[1]) / white[1]};
    }

    private double[][] adaptation() {
        double[] from = times(CONES, whiteXyz());
        double[] to = times(CONES, SRGB.whiteXyz());
        double[][] scaled = new double[3][];
        for (int cone = 0; cone < 3; cone++) {
            double gain = to[cone] / from[cone];
            scaled[cone] = Arrays.stream(CONES[cone]).map(value -> value * gain).toArray();
        }
        return product(inverse(CONES), scaled);
    }

    private static double[][] columns(double[]... chromaticities) {
        double[][] matrix = new double[3][3];
        for (int column = 0; column < 3; column++) {
            double x = chromaticities[column][0];
            double y = chromaticities[column][1];
            matrix[0][column] = x;
            matrix[1][column] = y;
            matrix[2][column] = 1 - x - y;
        }
        return matrix;
    }

    private static double[] times(double[][] matrix, double[] vector) {
        double[] result = new double[3];
        for (int row = 0; row < 3; row++) {
            result[row] = matrix[row][0] * vector[0] + matrix[row][1] * vector[1] + matrix[row][2] * vector[2];
        }
        return result;
    }

    private static double[][] product(double[][] left, double[][] right) {
        double[][] result = new double[3][3];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                for (int i = 0; i < 3; i++) {
                    result[row][column] += left[row][i] * right[i][column];
                }
            }
        }
        return result;
    }

    /** By cofactors; infinite or NaN where there is none. */
    private static double[][] inverse(double[][] matrix) {
        double[][] result = new double[3][3];
        double determinant = 0;
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                int nextRow = (row + 1) % 3;
                int lastRow = (row + 2) % 3;
                int nextColumn = (column + 1) % 3;
                int lastColumn = (column + 2) % 3;
                double cofactor = matrix[nextRow][nextColumn] * matrix[lastRow][lastColumn]
                        - matrix[nextRow][lastColumn] * matrix[lastRow][nextColumn];
                result[column][row] = cofactor;
                determinant += row == 0 ? matrix[0][column] * cofactor : 0;
            }
        }
        for (double[] row : result) {
            for (int column = 0; column < 3; column++) {
                row[column] /= determinant;
            }
        }
        return result;
    }
}
