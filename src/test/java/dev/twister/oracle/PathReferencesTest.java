package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Compares path-traced pictures with those of another renderer, Mitsuba 3.9 with 4,096 samples per pixel: the means of
 * 144 blocks of 15 x 15 pixels, whose standard errors are known. {@code -Dtwister.path.samples=4096} compares as
 * closely; with fewer samples the bounds are wider by their noise.
 */
class PathReferencesTest {
    private static final int WIDTH = 240;
    private static final int HEIGHT = 135;
    private static final int BLOCK = 15;
    private static final int BLOCKS_ACROSS = WIDTH / BLOCK;
    private static final int VALUES = 3 * BLOCKS_ACROSS * HEIGHT / BLOCK;

    /** Added to a value before relative errors, so that the dark counts less. */
    private static final double DARK = 0.02;

    /** Larger relative standard errors of the reference's values: these are not compared one by one. */
    private static final double SURE = 0.005;

    private static final int REFERENCE_SAMPLES = 4096;
    private static final int SAMPLES = Integer.getInteger("twister.path.samples", 16);

    /** Standard errors of these pictures at most, in those of the reference's at the same number of samples. */
    private static final double NOISE = SAMPLES < REFERENCE_SAMPLES ? 2 : 0;

    /** Values and their standard errors, channel by channel. */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Blocks(double[] values, double[] errors) {}

    /** @param worst of the mean of a block's channels */
    @ParameterizedTest
    @CsvSource({"weekend, 0.003, 0.005, 0.02", "box, 0.003, 0.005, 0.05", "knot, 0.003, 0.005, 0.02"})
    void blocksAreThoseOfAnotherRenderer(String name, double mean, double median, double worst) throws IOException {
        Blocks expected = reference(name);
        double[] actual = blocks(Pictures.radiance(JvmEngines.PARALLEL, scene(name, SAMPLES)));
        double[] errors = new double[VALUES];
        double[] noise = new double[VALUES];
        for (int i = 0; i < VALUES; i++) {
            double scale = expected.values()[i] + DARK;
            errors[i] = Math.abs(actual[i] - expected.values()[i]) / scale;
            noise[i] = NOISE * expected.errors()[i] * Math.sqrt((double) REFERENCE_SAMPLES / SAMPLES) / scale;
        }

        for (int channel = 0; channel < 3; channel++) {
            double sum = of(channel, expected.values()).sum();
            double difference = of(channel, actual).sum() / sum - 1;
            double squares =
                    of(channel, expected.errors()).map(error -> error * error).sum();
            double slack = 3 * NOISE * Math.sqrt(squares * REFERENCE_SAMPLES / SAMPLES) / sum;
            assertThat(Math.abs(difference)).as("mean of channel %d", channel).isLessThan(mean + slack);
        }
        assertThat(median(expected, errors)).as("median").isLessThan(median + median(expected, noise));
        for (int block = 0; block < VALUES; block += 3) {
            int first = block;
            double excess = IntStream.range(first, first + 3)
                            .filter(i -> isSure(expected, i))
                            .mapToDouble(i -> errors[i] - 4 * noise[i])
                            .sum()
                    / 3;
            assertThat(excess).as("block %d", block / 3).isLessThan(worst);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"weekend", "box", "knot"})
    void enginesAgree(String name) {
        LitScene few = PathReferences.scene(name, WIDTH / 3, HEIGHT / 3, 2);
        float[] expected = Pictures.radiance(JvmEngines.SEQUENTIAL, few);

        assertThat(Pictures.radiance(JvmEngines.PARALLEL, few)).isEqualTo(expected);
        assertThat(Pictures.radiance("vector", few)).isEqualTo(expected);
    }

    private static LitScene scene(String name, int samples) {
        return PathReferences.scene(name, WIDTH, HEIGHT, samples);
    }

    private static Blocks reference(String name) throws IOException {
        List<String> lines = Files.readAllLines(PathReferences.FOLDER.resolve(name + ".csv"));
        double[] values = new double[VALUES];
        double[] errors = new double[VALUES];
        for (int block = 0; block < VALUES / 3; block++) {
            String[] fields = lines.get(block + 1).split(",", -1);
            for (int channel = 0; channel < 3; channel++) {
                values[3 * block + channel] = Double.parseDouble(fields[2 + channel]);
                errors[3 * block + channel] = Double.parseDouble(fields[5 + channel]);
            }
        }
        return new Blocks(values, errors);
    }

    private static double[] blocks(float[] radiance) {
        double[] means = new double[VALUES];
        for (int i = 0; i < radiance.length; i++) {
            int column = i / 3 % WIDTH / BLOCK;
            int row = i / 3 / WIDTH / BLOCK;
            means[3 * (row * BLOCKS_ACROSS + column) + i % 3] += radiance[i] / (BLOCK * BLOCK);
        }
        return means;
    }

    private static DoubleStream of(int channel, double[] values) {
        return IntStream.range(0, VALUES).filter(i -> i % 3 == channel).mapToDouble(i -> values[i]);
    }

    private static double median(Blocks expected, double[] values) {
        double[] sorted = IntStream.range(0, VALUES)
                .filter(i -> isSure(expected, i))
                .mapToDouble(i -> values[i])
                .sorted()
                .toArray();
        return sorted[sorted.length / 2];
    }

    private static boolean isSure(Blocks expected, int i) {
        return expected.errors()[i] < SURE * (expected.values()[i] + DARK);
    }
}
