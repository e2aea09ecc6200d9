package dev.twister.engine;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import java.util.stream.IntStream;

/**
 * The noise of a picture whose samples form two independent halves: their difference tells the standard error of the
 * mean. It is measured in display values, as the root mean square in the noisiest block.
 *
 * @param width of the picture in pixels
 * @param frame the kernel's array of that name, whose exposure, tone map and sRGB curve count
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record NoiseEstimate(int width, float[] frame) {
    private static final int CHANNELS = 3;

    /** Side of the square blocks, in pixels. */
    private static final int BLOCK = 16;

    /**
     * The half of a picture's samples.
     *
     * @param sums of linear radiance, three floats per pixel
     * @param samples per pixel, at least 1
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    public record Half(float[] sums, int samples) {}

    /** The noise of the mean of all samples, relative to white. */
    public double of(Half one, Half other) {
        int height = one.sums().length / CHANNELS / width;
        int rows = Math.ceilDiv(height, BLOCK);
        double worst = IntStream.range(0, rows)
                .parallel()
                .mapToDouble(row -> noisiest(one, other, row * BLOCK, Math.min(height, (row + 1) * BLOCK)))
                .max()
                .orElse(0);
        // The variance of the mean of all samples is this part of the variance of the halves' difference.
        double all = one.samples() + other.samples();
        return Math.sqrt(worst * one.samples() / all * other.samples() / all);
    }

    private double noisiest(Half one, Half other, int top, int bottom) {
        double worst = 0;
        for (int left = 0; left < width; left += BLOCK) {
            worst = Math.max(worst, meanSquare(one, other, left, top, bottom));
        }
        return worst;
    }

    private double meanSquare(Half one, Half other, int left, int top, int bottom) {
        int right = Math.min(left + BLOCK, width);
        double sum = 0;
        for (int row = top; row < bottom; row++) {
            int end = CHANNELS * (row * width + right);
            for (int i = CHANNELS * (row * width + left); i < end; i++) {
                double difference = shown(one, i) - shown(other, i);
                sum += difference * difference;
            }
        }
        return sum / (CHANNELS * (right - left) * (bottom - top));
    }

    private float shown(Half half, int value) {
        return Tone.shown(
                half.sums()[value] / half.samples(),
                frame[Layout.EXPOSURE_SCALE],
                (int) frame[Layout.TONE_MAP],
                frame[Layout.SRGB]);
    }
}
