package dev.twister.world.table;

import dev.twister.kernel.DirectionalAlbedo;
import dev.twister.kernel.Sheen;
import java.util.Arrays;
import java.util.BitSet;

/** The two tables of {@link Sheen}: the albedo, and what divides the reflectance so that the albedo is at most 1. */
final class SheenTables {
    static final int TABLES = 2;
    private static final int STEPS = 24;
    private static final double LEAST_COSINE = 1e-4;

    private SheenTables() {}

    /** Fills rows of both tables. */
    static void fill(float[] tables, BitSet rows) {
        Arrays.stream(rows.stream().toArray()).parallel().forEach(row -> {
            double roughness = row / (DirectionalAlbedo.ROUGHNESSES - 1.0);
            double alpha = Math.max(roughness * roughness, Sheen.LEAST_ALPHA);
            int most = DirectionalAlbedo.TABLE_LENGTH + row * DirectionalAlbedo.COSINES;
            Arrays.fill(tables, most, most + DirectionalAlbedo.COSINES, 1);
            double[] whole = albedos(tables, most, alpha);
            boolean tooMuch = false;
            for (int column = 0; column < whole.length; column++) {
                tables[most + column] = (float) Math.max(1, whole[column]);
                tooMuch |= whole[column] > 1;
            }
            double[] kept = tooMuch ? albedos(tables, most, alpha) : whole;
            for (int column = 0; column < kept.length; column++) {
                tables[row * DirectionalAlbedo.COSINES + column] = (float) kept[column];
            }
        });
    }

    /** The integrals over outgoing directions, divided by a row of the second table for both directions. */
    private static double[] albedos(float[] table, int row, double alpha) {
        double[] albedos = new double[DirectionalAlbedo.COSINES];
        for (int column = 0; column < albedos.length; column++) {
            double root = column / (albedos.length - 1.0);
            double cosineIn = Math.max(root * root, LEAST_COSINE);
            for (int step = 0; step < STEPS; step++) {
                double rootOut = (step + 0.5) / STEPS;
                double place = rootOut * (albedos.length - 1);
                int left = (int) place;
                double most = table[row + left] + (place - left) * (table[row + left + 1] - table[row + left]);
                double cosine = rootOut * rootOut;
                albedos[column] += around(alpha, cosineIn, cosine) * cosine * 2 * rootOut / (STEPS * most);
            }
            albedos[column] /= table[row + column];
        }
        return albedos;
    }

    /** The integral over a turn about the normal. */
    private static double around(double alpha, double cosineIn, double cosineOut) {
        double sineIn = Math.sqrt(1 - cosineIn * cosineIn);
        double sineOut = Math.sqrt(1 - cosineOut * cosineOut);
        double up = cosineIn + cosineOut;
        double sum = 0;
        for (int step = 0; step < STEPS; step++) {
            double turn = Math.PI * (step + 0.5) / STEPS;
            double level = sineIn + sineOut * Math.cos(turn);
            double across = sineOut * Math.sin(turn);
            double flat = level * level + across * across;
            sum += Math.pow(flat / (flat + up * up), 1 / (2 * alpha));
        }
        double masked = 1 + lambda(alpha, cosineIn) + lambda(alpha, cosineOut);
        return (2 + 1 / alpha) * sum / (STEPS * 4 * cosineIn * cosineOut * masked);
    }

    private static double lambda(double alpha, double cosine) {
        return Math.exp(cosine < 0.5 ? fitted(alpha, cosine) : 2 * fitted(alpha, 0.5) - fitted(alpha, 1 - cosine));
    }

    private static double fitted(double alpha, double x) {
        double more = (1 - alpha) * (1 - alpha);
        double a = Sheen.A + more * Sheen.MORE_A;
        double b = Sheen.B + more * Sheen.MORE_B;
        double c = Sheen.C + more * Sheen.MORE_C;
        double d = Sheen.D + more * Sheen.MORE_D;
        return a / (1 + b * Math.pow(x, c)) + d * x + Sheen.E + more * Sheen.MORE_E;
    }
}
