package dev.twister.denoise;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Removes noise without a library: averages pixels whose surfaces and light are alike, by an edge-avoiding à-trous
 * wavelet transform (Dammertz et al. 2010) steered by the variance (Schied et al. 2017, "Spatiotemporal Variance-Guided
 * Filtering"), which is measured where the picture has its noise. So the filter fades out while samples gather. Light
 * is filtered without the color of the surface that it falls on.
 */
public final class GuidedFilter implements Denoiser {
    /** It runs everywhere. */
    public static final DenoiserOffer OFFER = DenoiserOffer.working("Twister's own filter", GuidedFilter::new);

    private static final int CHANNELS = 3;
    private static final int LEVELS = 5;
    private static final float LEAST_ALBEDO = 0.02f;

    /**
     * Samples from which neighbors in the sequence of samples cancel one another's errors, so that the difference of
     * two halves tells more noise than there is.
     */
    private static final double FEW_SAMPLES = 4;

    /** How fast that grows: what is left of the variance is the number of samples to this power. */
    private static final double CANCELING = -0.75;

    /** Of the nine pixels around a place, at most so many are a stray and its like. */
    private static final int MOST_STRAYS = 3;

    /** Of the same pixels, at least so many are alike beside a stray. */
    private static final int MAJORITY = 5;

    /** Samples from which the filtered picture fades out. */
    private static final float FADING_SAMPLES = 24;

    private static final float TINY = 1e-12f;

    @Override
    public float[] denoise(NoisyPicture picture) {
        return new Filtering(picture).result();
    }

    @Override
    public void close() {
        // Holds nothing.
    }

    /** One picture's pmeans. */
    private static final class Filtering {
        private final PlaneLayout layout;
        private final float[][] albedo;
        private final float[][] normal;

        /** Light without the color of the surface. */
        private final float[][] noisy;

        private final AlikeMeans means;
        private final Optional<NoisyPicture.Noise> noise;

        Filtering(NoisyPicture picture) {
            layout = new PlaneLayout(picture.width(), picture.height());
            noise = picture.noise();
            albedo = picture.guides()
                    .map(guides -> layout.planes(guides.albedo()))
                    .orElseGet(this::ones);
            normal = picture.guides()
                    .map(guides -> layout.planes(guides.normal()))
                    .orElseGet(this::ones);
            noisy = layout.planes(picture.radiance());
            means = new AlikeMeans(layout, normal, albedo);
            if (noise.map(NoisyPicture.Noise::samples).orElse(1) < FEW_SAMPLES) {
                replaceStrays();
            }
            untint(noisy);
        }

        private float[][] ones() {
            float[][] ones = {layout.plane(), layout.plane(), layout.plane()};
            for (float[] plane : ones) {
                Arrays.fill(plane, 1);
            }
            return ones;
        }

        /** Does something for the index of each pixel, and its row. */
        private void forEach(PixelAction action) {
            layout.rows().forEach(y -> {
                int first = layout.first(y);
                for (int pixel = first; pixel < first + layout.width(); pixel++) {
                    action.at(pixel, y);
                }
            });
        }

        @FunctionalInterface
        private interface PixelAction {
            void at(int pixel, int y);
        }

        /**
         * With few samples, glass shows what it mirrors in some pixels and what is behind it in the others. A pixel
         * whose surface is almost alone, where most of those around it are alike, takes the values of one of these.
         */
        private void replaceStrays() {
            int[] usual = new int[albedo[0].length];
            forEach((pixel, y) -> usual[pixel] = usual(pixel, y));
            for (float[][] planes : List.of(albedo, normal, noisy)) {
                for (float[] plane : planes) {
                    float[] before = plane.clone();
                    forEach((pixel, _) -> plane[pixel] = before[usual[pixel]]);
                }
            }
        }

        /** The pixel, or one of the majority around it. */
        private int usual(int pixel, int y) {
            int usual = pixel;
            if (alike(pixel, pixel, y) <= MOST_STRAYS) {
                for (int v = above(y); v <= below(y); v++) {
                    for (int u = -1; u <= 1; u++) {
                        int other = pixel + v * layout.stride() + u;
                        usual = alike(other, pixel, y) >= MAJORITY ? other : usual;
                    }
                }
            }
            return usual;
        }

        /** How many pixels around a place have a surface like that of a pixel. */
        private int alike(int pixel, int place, int y) {
            int count = 0;
            for (int v = above(y); v <= below(y); v++) {
                for (int u = -1; u <= 1; u++) {
                    count += means.isAlike(pixel, place + v * layout.stride() + u) ? 1 : 0;
                }
            }
            return count;
        }

        private int above(int y) {
            return y > 0 ? -1 : 0;
        }

        private int below(int y) {
            return y < layout.height() - 1 ? 1 : 0;
        }

        private void untint(float[][] colors) {
            for (int channel = 0; channel < CHANNELS; channel++) {
                float[] color = colors[channel];
                float[] tints = albedo[channel];
                forEach((pixel, _) -> color[pixel] /= tint(tints[pixel]));
            }
        }

        /** With single pixels that are brighter than all around them made as bright as the brightest of those. */
        private AlikeMeans.Light withoutSpeckles() {
            AlikeMeans.Light clean = AlikeMeans.Light.black(layout);
            float[] luminance = layout.plane();
            forEach((pixel, _) -> luminance[pixel] = luminance(noisy, pixel));
            forEach((pixel, y) -> {
                float brightest = 0;
                for (int v = above(y); v <= below(y); v++) {
                    for (int u = -1; u <= 1; u++) {
                        int other = pixel + v * layout.stride() + u;
                        brightest = other == pixel ? brightest : Math.max(brightest, luminance[other]);
                    }
                }
                float factor = Math.min(1, brightest / Math.max(TINY, luminance[pixel]));
                for (int channel = 0; channel < CHANNELS; channel++) {
                    clean.colors()[channel][pixel] = factor * noisy[channel][pixel];
                }
                clean.luminance()[pixel] = factor * luminance[pixel];
            });
            blur(noise.map(this::squares).orElseGet(() -> spread(clean.luminance())), clean.variance());
            return clean;
        }

        private void blur(float[] values, float[] blurred) {
            layout.rows().forEach(y -> means.mean(y, values, blurred));
        }

        /** Squares of the luminance of a picture of the noise alone. */
        private float[] squares(NoisyPicture.Noise known) {
            float[][] difference = layout.planes(known.difference());
            untint(difference);
            float share = (float) Math.pow(Math.max(1, known.samples() / FEW_SAMPLES), CANCELING);
            float[] squares = layout.plane();
            forEach((pixel, _) -> {
                float luminance = luminance(difference, pixel);
                squares[pixel] = share * luminance * luminance;
            });
            return squares;
        }

        /** Squares of the differences to the mean of the pixels around. */
        private float[] spread(float[] luminance) {
            float[] mean = layout.plane();
            blur(luminance, mean);
            float[] squares = layout.plane();
            forEach((pixel, _) -> {
                float difference = luminance[pixel] - mean[pixel];
                squares[pixel] = difference * difference;
            });
            return squares;
        }

        float[] result() {
            AlikeMeans.Light before = withoutSpeckles();
            AlikeMeans.Light from = before;
            AlikeMeans.Light spare = AlikeMeans.Light.black(layout);
            AlikeMeans.Light other = AlikeMeans.Light.black(layout);
            for (int level = 0; level < LEVELS; level++) {
                int step = 1 << level;
                AlikeMeans.Light source = from;
                AlikeMeans.Light target = spare;
                layout.rows().forEach(y -> means.average(y, step, source, target));
                spare = level == 0 ? other : source;
                from = target;
            }
            AlikeMeans.Light filtered = from;
            noise.ifPresent(known -> mix(filtered, before, Math.min(1, FADING_SAMPLES / known.samples())));
            float[] result = new float[CHANNELS * layout.width() * layout.height()];
            forEach((pixel, y) -> {
                int at = CHANNELS * (y * layout.width() + pixel - layout.first(y));
                for (int channel = 0; channel < CHANNELS; channel++) {
                    result[at + channel] = filtered.colors()[channel][pixel] * tint(albedo[channel][pixel]);
                }
            });
            return result;
        }

        /**
         * Takes back what the filter has blurred: where pixels have changed by more than their noise, it is light that
         * the average does not have.
         *
         * @param before the light before the filter, without speckles
         * @param most share of the filtered light
         */
        private void mix(AlikeMeans.Light filtered, AlikeMeans.Light before, float most) {
            float[] squares = layout.plane();
            forEach((pixel, _) -> {
                float change = filtered.luminance()[pixel] - before.luminance()[pixel];
                squares[pixel] = change * change;
            });
            float[] changes = layout.plane();
            blur(squares, changes);
            forEach((pixel, _) -> {
                float known = before.variance()[pixel];
                float kept = known / (known + Math.max(0, changes[pixel] - known) + TINY);
                for (int channel = 0; channel < CHANNELS; channel++) {
                    float old = before.colors()[channel][pixel];
                    float mixed = old + kept * (filtered.colors()[channel][pixel] - old);
                    float first = noisy[channel][pixel];
                    filtered.colors()[channel][pixel] = first + most * (mixed - first);
                }
            });
        }
    }

    /** What light is divided by for an albedo, so that it is light without the color of the surface. */
    public static float tint(float albedo) {
        return albedo < LEAST_ALBEDO ? 1 : albedo;
    }

    static float luminance(float[][] colors, int pixel) {
        return 0.2126f * colors[0][pixel] + 0.7152f * colors[1][pixel] + 0.0722f * colors[2][pixel];
    }
}
