package dev.twister.denoise;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

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

    /** A B3 spline. */
    private static final float[] KERNEL = {1f / 16, 1f / 4, 3f / 8, 1f / 4, 1f / 16};

    /** Half width of the window in which the variance is measured. */
    private static final int REACH = 2;

    private static final float LEAST_ALBEDO = 0.02f;

    /** Squared differences of normals and of albedos at which a weight is 1 / e. */
    private static final float NORMAL_SQUARED = 0.03f;

    private static final float ALBEDO_SQUARED = 0.01f;

    /** Squared difference of luminance, in variances of both pixels, at which a weight is 1 / e. */
    private static final float RANGE = 8;

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
    private static final float FADING_SAMPLES = 32;

    @Override
    public float[] denoise(NoisyPicture picture) {
        return new Filtering(picture).result();
    }

    @Override
    public void close() {
        // Holds nothing.
    }

    /** One picture's arrays: colors have three floats per pixel, variances one. */
    private static final class Filtering {
        private final int width;
        private final int height;
        private final float[] albedo;
        private final float[] normal;
        private final float[] tint;
        private final Optional<NoisyPicture.Noise> noise;
        private final float[] noisy;
        private float[] light;
        private float[] variance;

        Filtering(NoisyPicture picture) {
            width = picture.width();
            height = picture.height();
            noise = picture.noise();
            albedo = picture.guides().map(guides -> finite(guides.albedo())).orElseGet(() -> ones());
            normal = picture.guides().map(guides -> finite(guides.normal())).orElseGet(() -> ones());
            float[] radiance = finite(picture.radiance());
            if (noise.map(NoisyPicture.Noise::samples).orElse(1) < FEW_SAMPLES) {
                replaceStrays(List.of(albedo, normal, radiance));
            }
            tint = new float[albedo.length];
            for (int i = 0; i < tint.length; i++) {
                tint[i] = albedo[i] < LEAST_ALBEDO ? 1 : albedo[i];
            }
            noisy = untinted(radiance);
            light = withoutSpeckles(noisy);
            variance = noise.map(this::varianceOf).orElseGet(this::varianceOfNeighbors);
        }

        private float[] finite(Plane plane) {
            float[] values =
                    Arrays.copyOfRange(plane.values(), plane.first(), plane.first() + CHANNELS * width * height);
            for (int i = 0; i < values.length; i++) {
                values[i] = Float.isFinite(values[i]) ? values[i] : 0;
            }
            return values;
        }

        private float[] ones() {
            float[] ones = new float[CHANNELS * width * height];
            Arrays.fill(ones, 1);
            return ones;
        }

        /**
         * With few samples, glass shows what it mirrors in some pixels and what is behind it in the others. A pixel
         * whose surface is almost alone, where most of those around it are alike, takes the values of one of these.
         */
        private void replaceStrays(List<float[]> planes) {
            int[] usual = new int[width * height];
            rows().forEach(y -> {
                for (int x = 0; x < width; x++) {
                    usual[y * width + x] = usual(x, y);
                }
            });
            for (float[] plane : planes) {
                float[] before = plane.clone();
                for (int pixel = 0; pixel < usual.length; pixel++) {
                    System.arraycopy(before, CHANNELS * usual[pixel], plane, CHANNELS * pixel, CHANNELS);
                }
            }
        }

        /** The pixel, or one of the majority around it. */
        private int usual(int x, int y) {
            int own = y * width + x;
            int usual = own;
            for (int v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1) && alike(own, x, y) <= MOST_STRAYS; v++) {
                for (int u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); u++) {
                    usual = alike(v * width + u, x, y) >= MAJORITY ? v * width + u : usual;
                }
            }
            return usual;
        }

        /** How many pixels around a place have a surface like that of a pixel. */
        private int alike(int pixel, int x, int y) {
            int count = 0;
            for (int v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); v++) {
                for (int u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); u++) {
                    count += unlike(pixel, v * width + u) < 1 ? 1 : 0;
                }
            }
            return count;
        }

        private float[] untinted(float[] radiance) {
            for (int i = 0; i < radiance.length; i++) {
                radiance[i] /= tint[i];
            }
            return radiance;
        }

        /** With single pixels that are brighter than all around them made as bright as the brightest of those. */
        private float[] withoutSpeckles(float[] colors) {
            float[] clean = colors.clone();
            rows().forEach(y -> {
                for (int x = 0; x < width; x++) {
                    float brightest = 0;
                    for (int v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); v++) {
                        for (int u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); u++) {
                            brightest = u == x && v == y
                                    ? brightest
                                    : Math.max(brightest, luminance(colors, v * width + u));
                        }
                    }
                    int at = CHANNELS * (y * width + x);
                    float factor = Math.min(1, brightest / Math.max(1e-12f, luminance(colors, y * width + x)));
                    for (int i = at; i < at + CHANNELS; i++) {
                        clean[i] *= factor;
                    }
                }
            });
            return clean;
        }

        private IntStream rows() {
            return IntStream.range(0, height).parallel();
        }

        /** Of the luminance, from a picture of the noise alone. */
        private float[] varianceOf(NoisyPicture.Noise known) {
            float[] difference = untinted(finite(known.difference()));
            float share = (float) Math.pow(Math.max(1, known.samples() / FEW_SAMPLES), CANCELING);
            float[] squares = new float[width * height];
            for (int pixel = 0; pixel < squares.length; pixel++) {
                float luminance = luminance(difference, pixel);
                squares[pixel] = share * luminance * luminance;
            }
            return boxed(squares);
        }

        /** Of the luminance, from the differences to pixels beside. */
        private float[] varianceOfNeighbors() {
            float[] first = new float[width * height];
            float[] second = new float[width * height];
            for (int pixel = 0; pixel < first.length; pixel++) {
                first[pixel] = luminance(light, pixel);
                second[pixel] = first[pixel] * first[pixel];
            }
            float[] mean = boxed(first);
            float[] square = boxed(second);
            for (int pixel = 0; pixel < mean.length; pixel++) {
                square[pixel] = Math.max(0, square[pixel] - mean[pixel] * mean[pixel]);
            }
            return square;
        }

        /** The mean of the pixels around each one, by how alike their surfaces are. */
        private float[] boxed(float[] values) {
            float[] means = new float[values.length];
            rows().forEach(y -> {
                for (int x = 0; x < width; x++) {
                    int pixel = y * width + x;
                    float sum = 0;
                    float weights = 0;
                    for (int v = Math.max(0, y - REACH); v <= Math.min(height - 1, y + REACH); v++) {
                        for (int u = Math.max(0, x - REACH); u <= Math.min(width - 1, x + REACH); u++) {
                            int other = v * width + u;
                            float weight = (float) Math.exp(-unlike(pixel, other));
                            sum += weight * values[other];
                            weights += weight;
                        }
                    }
                    means[pixel] = sum / weights;
                }
            });
            return means;
        }

        private float unlike(int pixel, int other) {
            return squared(normal, pixel, other) / NORMAL_SQUARED + squared(albedo, pixel, other) / ALBEDO_SQUARED;
        }

        float[] result() {
            float[] before = light;
            float[] varianceBefore = variance;
            for (int level = 0; level < LEVELS; level++) {
                int step = 1 << level;
                float[] nextLight = new float[light.length];
                float[] nextVariance = new float[variance.length];
                rows().forEach(y -> {
                    for (int x = 0; x < width; x++) {
                        average(x, y, step, nextLight, nextVariance);
                    }
                });
                light = nextLight;
                variance = nextVariance;
            }
            noise.ifPresent(known -> mix(before, varianceBefore, Math.min(1, FADING_SAMPLES / known.samples())));
            for (int i = 0; i < light.length; i++) {
                light[i] *= tint[i];
            }
            return light;
        }

        /**
         * Takes back what the filter has blurred: where pixels have changed by more than their noise, it is light that
         * the average does not have.
         *
         * @param before the light before the filter, without speckles
         * @param most share of the filtered light
         */
        private void mix(float[] before, float[] varianceBefore, float most) {
            float[] squares = new float[varianceBefore.length];
            for (int pixel = 0; pixel < squares.length; pixel++) {
                float change = luminance(light, pixel) - luminance(before, pixel);
                squares[pixel] = change * change;
            }
            float[] changes = boxed(squares);
            for (int pixel = 0; pixel < squares.length; pixel++) {
                float known = varianceBefore[pixel];
                float kept = known / (known + Math.max(0, changes[pixel] - known) + 1e-12f);
                for (int i = CHANNELS * pixel; i < CHANNELS * pixel + CHANNELS; i++) {
                    float mixed = before[i] + kept * (light[i] - before[i]);
                    light[i] = noisy[i] + most * (mixed - noisy[i]);
                }
            }
        }

        private void average(int x, int y, int step, float[] nextLight, float[] nextVariance) {
            int pixel = y * width + x;
            float own = luminance(light, pixel);
            float weights = 0;
            float red = 0;
            float green = 0;
            float blue = 0;
            float spread = 0;
            for (int v = -2; v <= 2; v++) {
                int row = y + v * step;
                for (int u = -2; u <= 2 && row >= 0 && row < height; u++) {
                    int column = x + u * step;
                    if (column >= 0 && column < width) {
                        int other = row * width + column;
                        float difference = own - luminance(light, other);
                        float both = variance[pixel] + variance[other];
                        float range = difference * difference / (RANGE * both + 1e-12f);
                        float far = unlike(pixel, other) + range;
                        float weight = KERNEL[u + 2] * KERNEL[v + 2] * (float) Math.exp(-far);
                        weights += weight;
                        red += weight * light[CHANNELS * other];
                        green += weight * light[CHANNELS * other + 1];
                        blue += weight * light[CHANNELS * other + 2];
                        spread += weight * weight * variance[other];
                    }
                }
            }
            nextLight[CHANNELS * pixel] = red / weights;
            nextLight[CHANNELS * pixel + 1] = green / weights;
            nextLight[CHANNELS * pixel + 2] = blue / weights;
            nextVariance[pixel] = spread / (weights * weights);
        }

        private static float squared(float[] values, int pixel, int other) {
            float x = values[CHANNELS * pixel] - values[CHANNELS * other];
            float y = values[CHANNELS * pixel + 1] - values[CHANNELS * other + 1];
            float z = values[CHANNELS * pixel + 2] - values[CHANNELS * other + 2];
            return x * x + y * y + z * z;
        }

        private static float luminance(float[] colors, int pixel) {
            return 0.2126f * colors[CHANNELS * pixel]
                    + 0.7152f * colors[CHANNELS * pixel + 1]
                    + 0.0722f * colors[CHANNELS * pixel + 2];
        }
    }
}
