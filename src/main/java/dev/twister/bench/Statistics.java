package dev.twister.bench;

import java.util.Arrays;

/**
 * What the measured frames' times come to, in milliseconds.
 *
 * @param median the middle one, or the mean of the two middle ones
 * @param p95 the smallest time that at least 95 of 100 frames do not exceed (the nearest rank)
 */
public record Statistics(int frames, double min, double median, double mean, double p95) {
    private static final double NANOS_PER_MILLI = 1e6;

    /**
     * Sums up the times of the frames.
     *
     * @throws IllegalArgumentException where there is no time at all
     */
    public static Statistics ofNanos(long... nanos) {
        if (nanos.length == 0) {
            throw new IllegalArgumentException("no frame was measured");
        }
        double[] sorted = Arrays.stream(nanos)
                .sorted()
                .mapToDouble(n -> n / NANOS_PER_MILLI)
                .toArray();
        int count = sorted.length;
        double median = (sorted[(count - 1) / 2] + sorted[count / 2]) / 2;
        // In whole numbers: 0.95 * 20 is above 19 in doubles.
        int rank = (95 * count + 99) / 100;
        return new Statistics(
                count, sorted[0], median, Arrays.stream(sorted).average().orElseThrow(), sorted[rank - 1]);
    }

    /** Frames a second, from the mean as in the paper. */
    public double fps() {
        return 1000 / mean;
    }
}
