package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares sampled facets with the integral of their distribution. */
class FacetTest {
    private static final int FACETS = 100_000;
    private static final int BINS = 8;

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 0.7", "1, 0.1", "0.7, 0.9", "0.7, 0.4", "0.5, 0.2", "0.3, 0.6", "0.3, 0.05"})
    void normalsAreThoseThatAreVisible(float roughness, float viewCosine) {
        GgxIntegral integral = new GgxIntegral(roughness, viewCosine);
        int[] counts = new int[BINS * BINS];
        Random random = new Random(20261125);
        for (int facet = 0; facet < FACETS; facet++) {
            float[] normal = sample(random, roughness, viewCosine);
            counts[bin(integral, normal[0], normal[1], normal[2])]++;
        }
        double[] shares = new double[BINS * BINS];
        integral.visit((x, y, z, share) -> shares[bin(integral, x, y, z)] += share);
        assertThat(Arrays.stream(shares).sum()).isCloseTo(1, within(2e-3));
        double chiSquare = 0;
        int degrees = -1;
        for (int bin = 0; bin < counts.length; bin++) {
            double expected = FACETS * shares[bin];
            if (expected > 5) {
                chiSquare += (counts[bin] - expected) * (counts[bin] - expected) / expected;
                degrees++;
            } else {
                assertThat(counts[bin]).isLessThan(25);
            }
        }
        assertThat(chiSquare)
                .as("chi-square with %d degrees of freedom", degrees)
                .isLessThan(degrees + 5 * Math.sqrt(2.0 * degrees));
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 0.5", "1, 0.1", "0.7, 0.9", "0.5, 0.2", "0.3, 0.6", "0.1, 0.5"})
    void roughMirrorLosesWhatSingleScatteringLoses(float roughness, float viewCosine) {
        Random random = new Random(20261125);
        double sum = 0;
        for (int facet = 0; facet < FACETS; facet++) {
            float[] normal = sample(random, roughness, viewCosine);
            float viewX = (float) Math.sqrt(1 - viewCosine * viewCosine);
            float out = 2 * (viewX * normal[0] + viewCosine * normal[2]) * normal[2] - viewCosine;
            sum += out > 0 ? Facet.weight(roughness, viewCosine, out) : 0;
        }
        assertThat(sum / FACETS)
                .isCloseTo(new GgxIntegral(roughness, viewCosine).reflected(), within(2 / Math.sqrt(FACETS)));
    }

    /** Samples the view direction (sine, 0, cosine) on a surface with normal z, whose basis is x and y. */
    private static float[] sample(Random random, float roughness, float viewCosine) {
        float[] path = new float[Layout.PATH_LENGTH];
        path[Layout.DIRECTION] = -(float) Math.sqrt(1 - viewCosine * viewCosine);
        path[Layout.DIRECTION + 2] = -viewCosine;
        path[Layout.NORMAL + 2] = 1;
        path[Layout.ROUGHNESS] = roughness;
        float[] numbers = new float[Layout.SAMPLE_STRIDE];
        numbers[Layout.SAMPLE_SURFACE] = random.nextFloat();
        numbers[Layout.SAMPLE_SURFACE + 1] = random.nextFloat();
        Facet.find(path, numbers);
        return new float[] {path[Layout.FACET], path[Layout.FACET + 1], path[Layout.FACET + 2]};
    }

    private static int bin(GgxIntegral integral, double x, double y, double z) {
        int height = (int) (BINS * integral.height(z));
        int azimuth = (int) (BINS * (0.5 + Math.atan2(y, x) / (2 * Math.PI)));
        return BINS * height + Math.min(azimuth, BINS - 1);
    }
}
