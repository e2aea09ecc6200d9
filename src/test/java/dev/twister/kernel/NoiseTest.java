package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Rendering;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Statistics of the hash over a picture. */
class NoiseTest {
    private static final int SIDE = 256;
    private static final int PIXELS = SIDE * SIDE;
    private static final int PATHS = 512;

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 7, 15})
    void isEven(int place) {
        double sum = 0;
        double squares = 0;
        int[] counts = new int[256];
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            double number = number(pixel % SIDE, pixel / SIDE, place);
            sum += number;
            squares += number * number;
            counts[(int) (256 * number)]++;
        }
        double expected = PIXELS / 256.0;
        double chiSquare = 0;
        for (int count : counts) {
            chiSquare += (count - expected) * (count - expected) / expected;
        }
        // Bounds are five standard deviations of each moment of uniform random numbers.
        assertThat(sum / PIXELS).isBetween(0.5 - 0.0057, 0.5 + 0.0057);
        assertThat(squares / PIXELS).isBetween(1 / 3.0 - 0.0059, 1 / 3.0 + 0.0059);
        assertThat(chiSquare).as("chi-square with 255 degrees of freedom").isLessThan(255 + 5 * Math.sqrt(2 * 255));
    }

    /** No correlation with neighbors or with the other numbers of the pixel. */
    @ParameterizedTest
    @CsvSource({
        "1, 0, 0",
        "0, 1, 0",
        "1, 1, 0",
        "-1, 1, 0",
        "2, 0, 0",
        "0, 2, 0",
        "4, 0, 0",
        "0, 8, 0",
        "16, 0, 0",
        "0, 64, 0",
        "0, 0, 1",
        "0, 0, 2",
        "0, 0, 6",
        "1, 0, 1",
        "0, 1, 1"
    })
    void doesNotCorrelate(int right, int down, int placesOn) {
        for (int place = 2; place < 8; place++) {
            double sum = 0;
            for (int pixel = 0; pixel < PIXELS; pixel++) {
                int column = 100 + pixel % SIDE;
                int row = 100 + pixel / SIDE;
                sum += (number(column, row, place) - 0.5)
                        * (number(column + right, row + down, place + placesOn) - 0.5);
            }
            double correlation = 12 * sum / PIXELS;
            assertThat(Math.abs(correlation))
                    .as("correlation at place %d", place)
                    .isLessThan(5 / Math.sqrt(PIXELS));
        }
    }

    /** Differences of neighbors are distributed like those of random numbers: no stripes or gradients. */
    @ParameterizedTest
    @CsvSource({"1, 0", "0, 1", "1, 1", "1, -1"})
    void neighborsDifferEvenly(int right, int down) {
        int[] counts = new int[64];
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            int column = 1 + pixel % SIDE;
            int row = 1 + pixel / SIDE;
            double difference = number(column, row, 4) - number(column + right, row + down, 4);
            counts[(int) (64 * (difference - Math.floor(difference)))]++;
        }
        double expected = PIXELS / 64.0;
        double chiSquare = 0;
        for (int count : counts) {
            chiSquare += (count - expected) * (count - expected) / expected;
        }
        assertThat(chiSquare).as("chi-square with 63 degrees of freedom").isLessThan(63 + 5 * Math.sqrt(2 * 63));
    }

    /** Picture sides are at most 16,384, and the product must not overflow beyond that either. */
    @ParameterizedTest
    @CsvSource({"0, 0, 2", "16383, 16383, 15", "65535, 65535, 15", "65535, 0, 2", "42195, 1, 2", "16383, 1, 459"})
    void staysInItsRange(int column, int row, int place) {
        assertThat(Noise.hash(column, row, place)).isBetween(0, 65535);
    }

    /** Every pair of bounces of a path, over the samples of one pixel. */
    @Test
    void bouncesOfAPathDoNotCorrelate() {
        int samples = 4096;
        float[] frame = frame(samples);
        for (int bounce = 0; bounce < 20; bounce++) {
            for (int later = bounce + 1; later < 20; later++) {
                double sum = 0;
                for (int sample = 0; sample < samples; sample++) {
                    sum += (surface(frame, sample, bounce) - 0.5) * (surface(frame, sample, later) - 0.5);
                }
                assertThat(Math.abs(12 * sum / samples))
                        .as("bounces %d and %d", bounce, later)
                        .isLessThan(5 / Math.sqrt(samples));
            }
        }
    }

    private static double surface(float[] frame, int sample, int bounce) {
        return Noise.fresh(path(123, 45, sample), Noise.surface(bounce), frame);
    }

    private static float[] path(int column, int row, int sample) {
        float[] path = new float[Layout.TRACED_PATH_LENGTH];
        path[Layout.PIXEL_COLUMN] = column;
        path[Layout.PIXEL_ROW] = row;
        path[Layout.PIXEL_SAMPLE] = Layout.DISC + Layout.SAMPLE_STRIDE * sample;
        return path;
    }

    /** Every pair of the numbers that one path can draw, over the samples of one pixel. */
    @Test
    void numbersOfAPathAreIndependentOverSamples() {
        float[] frame = frame(PATHS);
        requireIndependence(IntStream.range(0, PATHS).mapToObj(sample -> path(123, 45, sample)), frame);
    }

    /** The same over pixels. */
    @Test
    void numbersOfAPathAreIndependentOverPixels() {
        requireIndependence(
                IntStream.range(0, PATHS).mapToObj(pixel -> path(300 + pixel % 64, 200 + pixel / 64, 0)), frame(1));
    }

    private static void requireIndependence(Stream<float[]> paths, float[] frame) {
        double[][] numbers = paths.map(path -> numbers(path, frame)).toArray(double[][]::new);
        int count = numbers[0].length;
        assertThat(count).isGreaterThan(6 * (Layout.MOST_BOUNCES + 1));
        List<String> dependent = new ArrayList<>();
        for (DoubleUnaryOperator shape : List.<DoubleUnaryOperator>of(
                x -> Math.sqrt(12) * (x - 0.5), x -> Math.sqrt(2) * Math.cos(2 * Math.PI * x))) {
            float[][] shaped = new float[count][PATHS];
            for (int number = 0; number < count; number++) {
                for (int path = 0; path < PATHS; path++) {
                    shaped[number][path] = (float) shape.applyAsDouble(numbers[path][number]);
                }
            }
            for (int number = 0; number < count; number++) {
                for (int other = number + 1; other < count; other++) {
                    float sum = 0;
                    for (int path = 0; path < PATHS; path++) {
                        sum += shaped[number][path] * shaped[other][path];
                    }
                    if (Math.abs(sum / PATHS) > 6 / Math.sqrt(PATHS)) {
                        dependent.add("%d and %d: %.3f".formatted(number, other, sum / PATHS));
                    }
                }
            }
        }
        assertThat(dependent).isEmpty();
    }

    /** For the lens, for each surface, for its end, and for each of some triangles that each of some rays meets. */
    private static double[] numbers(float[] path, float[] frame) {
        DoubleStream.Builder numbers = DoubleStream.builder();
        for (int place = Layout.SAMPLE_LENS; place < Noise.scatter(Layout.MOST_BOUNCES) + 3; place++) {
            numbers.add(Noise.fresh(path, place, frame));
        }
        for (int bounce = PathTracer.FIRST_ROULETTE; bounce <= Layout.MOST_BOUNCES; bounce++) {
            numbers.add(Noise.fresh(path, Noise.roulette(bounce), frame));
        }
        for (int triangle : new int[] {0, 1, 2, 3, 0x10000, 0x10001}) {
            for (int body : new int[] {2, 3, 0x10002}) {
                for (int ray = 0; ray < 6; ray++) {
                    path[Layout.RAYS] = ray;
                    numbers.add(Noise.crossing(path, body, triangle, frame));
                }
            }
        }
        return numbers.build().toArray();
    }

    /** No line of equal numbers across a picture. */
    @Test
    void keysOfColumnAndRowDifferByMoreThanPictures() {
        for (int place = Layout.SAMPLE_STRIDE; place < Noise.roulette(Layout.MOST_BOUNCES); place++) {
            assertThat(Noise.columnKey(place) ^ Noise.rowKey(place))
                    .as("place %d", place)
                    .isGreaterThanOrEqualTo(Rendering.MAX_SIDE);
        }
    }

    /** With the numbers of {@code world.PixelSamples}. */
    private static float[] frame(int samples) {
        int[] primes = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43};
        float[] frame = new float[Layout.DISC + Layout.SAMPLE_STRIDE * samples];
        frame[Layout.SAMPLES] = Layout.DISC;
        for (int sample = 0; sample < samples; sample++) {
            for (int number = 0; number < primes.length; number++) {
                frame[Layout.DISC + Layout.SAMPLE_STRIDE * sample + Layout.SAMPLE_LENS + number] =
                        (float) ((0.5 + sample * Math.sqrt(primes[number])) % 1);
            }
        }
        return frame;
    }

    private static double number(int column, int row, int place) {
        return Noise.hash(column, row, place) / 65536.0;
    }
}
