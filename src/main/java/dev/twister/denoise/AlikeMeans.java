package dev.twister.denoise;

import java.util.Arrays;

/**
 * Means of pixels whose surfaces are alike; pixels in a border are like no other. Rows are copied, since the JIT
 * compiler makes SIMD code of loops that read and write all arrays at the same index.
 */
final class AlikeMeans {
    /** Pixels to either side of the one whose mean is computed. */
    private static final int REACH = 2;

    /** A B3 spline. */
    private static final float[] SPLINE = {1f / 16, 1f / 4, 3f / 8, 1f / 4, 1f / 16};

    /** Squared differences of normals and of albedos at which a weight is about 1 / e. */
    private static final float NORMAL_SQUARED = 0.03f;

    private static final float ALBEDO_SQUARED = 0.01f;

    /** Squared difference of luminance, in variances of both pixels, at which a weight is about 1 / e. */
    private static final float RANGE = 8;

    private static final float TINY = 1e-12f;

    /** The exponential function is the limit of {@code (1 + x / n)^n} for large n; this is n. */
    private static final float POWER = 16;

    /** A component of a normal that is like no other. */
    private static final float ELSEWHERE = 1e4f;

    private final PlaneLayout layout;
    private final float[][] normal;
    private final float[][] albedo;

    /**
     * The surfaces of a picture.
     *
     * @param normal three planes; their borders are overwritten
     * @param albedo three planes
     */
    AlikeMeans(PlaneLayout layout, float[][] normal, float[][] albedo) {
        this.layout = layout;
        this.normal = normal;
        this.albedo = albedo;
        for (int y = 0; y < layout.height(); y++) {
            int first = layout.first(y);
            Arrays.fill(normal[0], first - PlaneLayout.BORDER, first, ELSEWHERE);
            int end = first + layout.width();
            Arrays.fill(normal[0], end, end + PlaneLayout.BORDER, ELSEWHERE);
        }
    }

    /**
     * Light of each pixel.
     *
     * @param colors three planes
     * @param luminance of the colors
     * @param variance of the luminance
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    record Light(float[][] colors, float[] luminance, float[] variance) {
        static Light black(PlaneLayout layout) {
            return new Light(
                    new float[][] {layout.plane(), layout.plane(), layout.plane()}, layout.plane(), layout.plane());
        }
    }

    /** Weights of the pixels that are so far to the right of and below those of a row. */
    private final class Weights {
        private final int first;
        private final float[][] ownNormal;
        private final float[][] ownAlbedo;
        private final float[] values = row();
        private final float[] far = row();
        private final float[] sums = row();
        private final float[] other = row();

        Weights(int first) {
            this.first = first;
            ownNormal = rows(normal, first);
            ownAlbedo = rows(albedo, first);
        }

        /** Begins with how far the surfaces are from one another. */
        void surfaces(int offset) {
            Arrays.fill(far, 0);
            for (int channel = 0; channel < normal.length; channel++) {
                addSquares(ownNormal[channel], read(normal[channel], offset), 1 / NORMAL_SQUARED, far);
                addSquares(ownAlbedo[channel], read(albedo[channel], offset), 1 / ALBEDO_SQUARED, far);
            }
        }

        void finish(float scale) {
            weigh(far, scale, values);
            add(values, sums);
        }

        /** The row that is offset; valid until the next call. */
        float[] read(float[] plane, int offset) {
            System.arraycopy(plane, first + offset, other, 0, other.length);
            return other;
        }
    }

    private float[] row() {
        return new float[layout.width()];
    }

    private float[][] rows(float[][] planes, int first) {
        float[][] rows = new float[planes.length][];
        for (int plane = 0; plane < rows.length; plane++) {
            rows[plane] = Arrays.copyOfRange(planes[plane], first, first + layout.width());
        }
        return rows;
    }

    /**
     * Averages a row for one level of the wavelet transform.
     *
     * @param step pixels between those that are averaged, at most {@link PlaneLayout#BORDER} / 2
     */
    void average(int y, int step, Light from, Light to) {
        int first = layout.first(y);
        Weights weights = new Weights(first);
        float[] luminance = Arrays.copyOfRange(from.luminance, first, first + layout.width());
        float[] variance = Arrays.copyOfRange(from.variance, first, first + layout.width());
        float[] otherLuminance = row();
        float[] spread = row();
        float[][] colors = {row(), row(), row()};
        for (int v = -REACH; v <= REACH; v++) {
            int row = y + v * step;
            for (int u = -REACH; u <= REACH && row >= 0 && row < layout.height(); u++) {
                int offset = v * step * layout.stride() + u * step;
                weights.surfaces(offset);
                System.arraycopy(from.luminance, first + offset, otherLuminance, 0, otherLuminance.length);
                float[] otherVariance = weights.read(from.variance, offset);
                addRange(luminance, otherLuminance, variance, otherVariance, weights.far);
                weights.finish(SPLINE[u + REACH] * SPLINE[v + REACH]);
                addSquaredProducts(weights.values, otherVariance, spread);
                for (int channel = 0; channel < colors.length; channel++) {
                    addProducts(weights.values, weights.read(from.colors[channel], offset), colors[channel]);
                }
            }
        }
        for (int x = 0; x < layout.width(); x++) {
            float sum = weights.sums[x];
            for (int channel = 0; channel < colors.length; channel++) {
                to.colors[channel][first + x] = colors[channel][x] / sum;
            }
            to.luminance[first + x] = GuidedFilter.luminance(to.colors, first + x);
            to.variance[first + x] = spread[x] / (sum * sum);
        }
    }

    /** Computes a row of the means of the pixels around each one. */
    void mean(int y, float[] values, float[] means) {
        int first = layout.first(y);
        Weights weights = new Weights(first);
        float[] sums = row();
        for (int v = Math.max(-REACH, -y); v <= REACH && y + v < layout.height(); v++) {
            for (int u = -REACH; u <= REACH; u++) {
                int offset = v * layout.stride() + u;
                weights.surfaces(offset);
                weights.finish(1);
                addProducts(weights.values, weights.read(values, offset), sums);
            }
        }
        for (int x = 0; x < layout.width(); x++) {
            means[first + x] = sums[x] / weights.sums[x];
        }
    }

    private static void addSquares(float[] own, float[] other, float scale, float[] far) {
        for (int x = 0; x < far.length; x++) {
            float difference = own[x] - other[x];
            far[x] += scale * (difference * difference);
        }
    }

    private static void addRange(float[] own, float[] other, float[] variance, float[] otherVariance, float[] far) {
        for (int x = 0; x < far.length; x++) {
            float difference = own[x] - other[x];
            far[x] += difference * difference / (RANGE * (variance[x] + otherVariance[x]) + TINY);
        }
    }

    /** About {@code scale * exp(-far)}; 0 from {@link #POWER} on. */
    private static void weigh(float[] far, float scale, float[] weights) {
        for (int x = 0; x < weights.length; x++) {
            float root = Math.max(0f, 1f - far[x] * (1 / POWER));
            float square = root * root;
            float fourth = square * square;
            float eighth = fourth * fourth;
            weights[x] = scale * (eighth * eighth);
        }
    }

    private static void add(float[] values, float[] sums) {
        for (int x = 0; x < sums.length; x++) {
            sums[x] += values[x];
        }
    }

    private static void addProducts(float[] weights, float[] values, float[] sums) {
        for (int x = 0; x < sums.length; x++) {
            sums[x] += weights[x] * values[x];
        }
    }

    private static void addSquaredProducts(float[] weights, float[] values, float[] sums) {
        for (int x = 0; x < sums.length; x++) {
            sums[x] += weights[x] * weights[x] * values[x];
        }
    }

    /** Whether the surfaces of two pixels are so alike that a weight is more than 1 / e. */
    boolean isAlike(int pixel, int other) {
        float normals = 0;
        float albedos = 0;
        for (int channel = 0; channel < normal.length; channel++) {
            float turn = normal[channel][pixel] - normal[channel][other];
            float tint = albedo[channel][pixel] - albedo[channel][other];
            normals += turn * turn;
            albedos += tint * tint;
        }
        return normals / NORMAL_SQUARED + albedos / ALBEDO_SQUARED < 1;
    }
}
