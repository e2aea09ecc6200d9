package dev.twister.bench.report;

/**
 * One engine at one setting, as a report has it.
 *
 * @param name what is the same in two reports that can be compared: scene, engine, size and quality
 * @param frames that were measured
 * @param medianMillis of a frame
 * @param p95Millis below which 95 % of the frames are
 * @param samePicture whether the picture was that of {@code sequential}
 */
record TimedRow(String name, int frames, double medianMillis, double p95Millis, boolean samePicture) {
    /** The standard deviation of a normal distribution is this many times below its 95th percentile. */
    private static final double P95_DEVIATIONS = 1.645;

    /** The standard error of a median over that of a mean. */
    private static final double MEDIAN_FACTOR = 1.253;

    /** Standard error of the median, as a share of it, estimated from the 95th percentile. */
    double relativeError() {
        double deviation = Math.max(0, p95Millis - medianMillis) / P95_DEVIATIONS;
        return MEDIAN_FACTOR * deviation / Math.sqrt(frames) / medianMillis;
    }
}
