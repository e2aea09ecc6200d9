package dev.twister.sky.daylight;

/**
 * How luminance or a chromaticity spreads over a clear sky: {@code F = (1 + a e^(b / cos theta)) (1 + c e^(d gamma) + e
 * cos^2 gamma)}, theta the angle from the zenith, gamma the angle from the sun (Perez, Seals and Michalsky 1993).
 */
record Perez(double a, double b, double c, double d, double e) {
    /** Keeps b / cos theta finite on the horizon, where the exponential is 0 either way. */
    private static final double SMALLEST_COSINE = 1e-4;

    double relative(double cosTheta, double cosGamma, double gamma) {
        return (1 + a * StrictMath.exp(b / Math.max(cosTheta, SMALLEST_COSINE)))
                * (1 + c * StrictMath.exp(d * gamma) + e * cosGamma * cosGamma);
    }
}
