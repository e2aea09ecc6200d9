package dev.twister.sky.daylight;

/**
 * The clear sky of Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight" (SIGGRAPH 1999), appendix
 * A.2: luminance in kcd/m² and color in any direction above the horizon.
 *
 * <p>Of the chromaticity only x is the paper's; y follows from it by the CIE's daylight locus, {@code y = -3 x^2 + 2.87
 * x - 0.275} (CIE 15). The paper's own fit of y strays from the colors daylight has: pink at a noon's horizon, green at
 * an evening's.
 */
public final class PreethamSky {
    /** Where the locus is kept from running into colors that no sky has. */
    private static final double BLUEST_X = 0.23;

    private static final double REDDEST_X = 0.48;

    private final Perez luminanceShape;
    private final Perez xShape;
    private final double luminanceFactor;
    private final double xFactor;

    /**
     * @param sunZenithAngle the sun's angle from the zenith in radians, 0 to pi / 2
     * @param turbidity 2 to 10
     */
    public PreethamSky(double sunZenithAngle, double turbidity) {
        double t = turbidity;
        luminanceShape = new Perez(
                0.17872 * t - 1.46303,
                -0.35540 * t + 0.42749,
                -0.02266 * t + 5.32505,
                0.12064 * t - 2.57705,
                -0.06696 * t + 0.37027);
        xShape = new Perez(
                -0.01925 * t - 0.25922,
                -0.06651 * t + 0.00081,
                -0.00041 * t + 0.21247,
                -0.06409 * t - 0.89887,
                -0.00325 * t + 0.04517);
        double cosSun = StrictMath.cos(sunZenithAngle);
        luminanceFactor = zenithLuminance(sunZenithAngle, t) / luminanceShape.relative(1, cosSun, sunZenithAngle);
        xFactor = zenithX(sunZenithAngle, t) / xShape.relative(1, cosSun, sunZenithAngle);
    }

    /** Linear sRGB radiance in kcd/m², colors beyond the gamut cut at 0. */
    public Color radiance(double cosTheta, double cosGamma) {
        double gamma = StrictMath.acos(Math.clamp(cosGamma, -1, 1));
        double x = Math.clamp(xFactor * xShape.relative(cosTheta, cosGamma, gamma), BLUEST_X, REDDEST_X);
        double y = (2.870 - 3.000 * x) * x - 0.275;
        return Color.ofChromaticity(x, y, luminanceFactor * luminanceShape.relative(cosTheta, cosGamma, gamma));
    }

    /** Luminance straight up, in kcd/m². */
    public static double zenithLuminance(double sunZenithAngle, double turbidity) {
        double chi = (4.0 / 9 - turbidity / 120) * (Math.PI - 2 * sunZenithAngle);
        return (4.0453 * turbidity - 4.9710) * StrictMath.tan(chi) - 0.2155 * turbidity + 2.4192;
    }

    private static double zenithX(double angle, double turbidity) {
        return quadratic(
                turbidity,
                cubic(angle, 0.00166, -0.00375, 0.00209, 0),
                cubic(angle, -0.02903, 0.06377, -0.03202, 0.00394),
                cubic(angle, 0.11693, -0.21196, 0.06052, 0.25886));
    }

    private static double cubic(double x, double third, double second, double first, double constant) {
        return ((third * x + second) * x + first) * x + constant;
    }

    private static double quadratic(double x, double second, double first, double constant) {
        return (second * x + first) * x + constant;
    }

    /**
     * How luminance or a chromaticity spreads over a clear sky: {@code F = (1 + a e^(b / cos theta)) (1 + c e^(d gamma)
     * + e cos^2 gamma)}, theta the angle from the zenith, gamma the angle from the sun (Perez, Seals and Michalsky
     * 1993).
     */
    private record Perez(double a, double b, double c, double d, double e) {
        /** Keeps b / cos theta finite on the horizon, where the exponential is 0 either way. */
        private static final double SMALLEST_COSINE = 1e-4;

        double relative(double cosTheta, double cosGamma, double gamma) {
            return (1 + a * StrictMath.exp(b / Math.max(cosTheta, SMALLEST_COSINE)))
                    * (1 + c * StrictMath.exp(d * gamma) + e * cosGamma * cosGamma);
        }
    }
}
