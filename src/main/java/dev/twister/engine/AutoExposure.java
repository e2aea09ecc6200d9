package dev.twister.engine;

import dev.twister.kernel.Tone;
import dev.twister.scene.Rendering;
import java.util.OptionalDouble;

/**
 * The exposure that a picture asks for: its log-average luminance becomes middle gray, as in Reinhard et al.,
 * "Photographic Tone Reproduction for Digital Images" (2002), equations 1 and 2. As in the histogram-based exposure of
 * game engines, the darkest and the brightest tenth do not count, so that neither a lamp nor a night sky rules it; nor
 * do pixels without light. All tone maps here begin with the exposed luminance, so the key is the same for all.
 */
public final class AutoExposure {
    /** Of what the screen is to show: the reflectance of a photographer's gray card. */
    private static final float MIDDLE_GRAY = 0.18f;

    private static final double LEFT_OUT = 0.1;

    private static final int CHANNELS = 3;
    private static final double RED = 0.2126;
    private static final double GREEN = 0.7152;
    private static final double BLUE = 0.0722;

    /** Of float radiance, the smallest ones included. */
    private static final int LEAST_STOPS = -160;

    private static final int MOST_STOPS = 130;
    private static final int BINS_PER_STOP = 64;
    private static final int BINS = (MOST_STOPS - LEAST_STOPS) * BINS_PER_STOP;
    private static final double LOG_2 = StrictMath.log(2);
    private static final double STEPS_PER_STOP = 100;

    private AutoExposure() {}

    /**
     * The exposure in stops, in hundredths, from -20 to 20; empty where no pixel has light.
     *
     * @param radiance three floats a pixel: linear red, green and blue; pixels that are not finite do not count
     * @param srgb whether the sRGB curve follows the tone map; without it the screen takes the tone-mapped numbers for
     *     encoded ones, so the key is middle gray's sRGB code, 0.46
     */
    public static OptionalDouble stops(float[] radiance, boolean srgb) {
        long[] counts = new long[BINS];
        double[] sums = new double[BINS];
        long counted = 0;
        for (int at = 0; at + CHANNELS <= radiance.length; at += CHANNELS) {
            double luminance = RED * radiance[at] + GREEN * radiance[at + 1] + BLUE * radiance[at + 2];
            if (luminance > 0 && luminance < Double.POSITIVE_INFINITY) {
                double stops = StrictMath.log(luminance) / LOG_2;
                int bin = Math.clamp((long) ((stops - LEAST_STOPS) * BINS_PER_STOP), 0, BINS - 1);
                counts[bin]++;
                sums[bin] += stops;
                counted++;
            }
        }
        return counted == 0
                ? OptionalDouble.empty()
                : OptionalDouble.of(stops(trimmedMean(counts, sums, counted), srgb));
    }

    private static double stops(double logAverage, boolean srgb) {
        float key = srgb ? MIDDLE_GRAY : Tone.srgbEncoded(MIDDLE_GRAY);
        double stops = StrictMath.log(key) / LOG_2 - logAverage;
        double rounded = Math.round(stops * STEPS_PER_STOP) / STEPS_PER_STOP;
        return Math.clamp(rounded, -Rendering.MAX_EXPOSURE_STOPS, Rendering.MAX_EXPOSURE_STOPS);
    }

    /** A bin that is cut counts by its mean. */
    private static double trimmedMean(long[] counts, double[] sums, long counted) {
        double from = LEFT_OUT * counted;
        double to = (1 - LEFT_OUT) * counted;
        double below = 0;
        double sum = 0;
        double weight = 0;
        for (int bin = 0; bin < BINS; bin++) {
            double inside = Math.min(to, below + counts[bin]) - Math.max(from, below);
            if (inside > 0) {
                sum += inside * sums[bin] / counts[bin];
                weight += inside;
            }
            below += counts[bin];
        }
        return sum / weight;
    }
}
