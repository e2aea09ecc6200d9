package dev.twister.bench;

import java.util.Arrays;

/**
 * Statistics of the measured frames' times, in milliseconds.
 *
 * @param median the middle time, or the mean of the two middle ones
 * @param p95 the smallest time that at least 95 of 100 frames do not exceed (nearest rank)
 */
public record Statistics(int frames, double min, double median, double mean, double p95) {
    private static final double NANOS_PER_MILLI = 1e6;

    /**
     * Computes the statistics.
     *
     * @param nanos times in nanoseconds
     * @throws IllegalArgumentException if there are no times
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
        // In integers, because 0.95 * 20 exceeds 19 in doubles.
        int rank = (95 * count + 99) / 100;
        return new Statistics(
                count, sorted[0], median, Arrays.stream(sorted).average().orElseThrow(), sorted[rank - 1]);
    }

    /** Frames per second, from the mean as in the paper. */
    public double fps() {
        return 1000 / mean;
    }
}
