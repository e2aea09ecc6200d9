package dev.twister.engine;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The noise of a picture whose samples form two independent halves: their difference tells the standard error of the
 * mean. It is measured in display values, as the root mean square in a tile.
 *
 * @param width of the picture in pixels
 * @param frame the kernel's array of that name, whose exposure, tone map and sRGB curve count
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record NoiseEstimate(int width, float[] frame) {
    private static final int CHANNELS = 3;

    /** Side of the tiles, in pixels. */
    private static final int BLOCK = Layout.TILE_SIDE;

    /**
     * The half of a picture's samples.
     *
     * @param sums of linear radiance, three floats per pixel
     * @param samples per pixel, at least 1
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    public record Half(float[] sums, int samples) {}

    /** The noise of the mean of all samples in the noisiest tile, relative to white. */
    public double of(Half one, Half other) {
        return Arrays.stream(tiles(one, other)).max().orElse(0);
    }

    /** The noise of the mean of all samples in each tile, from the top left, relative to white. */
    public double[] tiles(Half one, Half other) {
        int height = one.sums().length / CHANNELS / width;
        int across = Math.ceilDiv(width, BLOCK);
        // The variance of the mean of all samples is this part of the variance of the halves' difference.
        double all = one.samples() + other.samples();
        double part = one.samples() / all * other.samples() / all;
        return IntStream.range(0, across * Math.ceilDiv(height, BLOCK))
                .parallel()
                .mapToDouble(tile -> {
                    int top = tile / across * BLOCK;
                    return part * meanSquare(one, other, tile % across * BLOCK, top, Math.min(height, top + BLOCK));
                })
                .map(Math::sqrt)
                .toArray();
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
