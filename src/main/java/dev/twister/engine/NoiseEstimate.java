package dev.twister.engine;

import dev.twister.engine.RareLight.Finds;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import java.util.Arrays;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;

/**
 * The noise of a picture whose samples form two independent halves: their difference tells the standard error of the
 * mean, and what {@link RareLight} may be missing. It is measured in display values, as the root mean square in a tile.
 *
 * @param width of the picture in pixels
 * @param frame the kernel's array of that name, whose exposure, tone map and sRGB curve count
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record NoiseEstimate(int width, float[] frame) {
    private static final int CHANNELS = 3;

    /** Side of the tiles, in pixels. */
    private static final int BLOCK = Layout.TILE_SIDE;

    /** Display values from which on a pixel does not get visibly brighter. */
    private static final double WHITE = 0.98;

    /**
     * The half of a picture's samples.
     *
     * @param sums of linear radiance, three floats per pixel
     * @param samples per pixel of each tile, at least 1; tiles are counted from the top left
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    public record Half(float[] sums, IntUnaryOperator samples) {
        /** A half with the same number of samples in all pixels. */
        public Half(float[] sums, int samples) {
            this(sums, _ -> samples);
        }
    }

    /** The noise of the mean of all samples in the noisiest tile, relative to white. */
    public double of(Half one, Half other) {
        return Arrays.stream(tiles(one, other)).max().orElse(0);
    }

    /** The noise of the mean of all samples in each tile, from the top left, relative to white. */
    public double[] tiles(Half one, Half other) {
        int height = one.sums().length / CHANNELS / width;
        int across = Math.ceilDiv(width, BLOCK);
        int count = across * Math.ceilDiv(height, BLOCK);
        Tile[] tiles = IntStream.range(0, count)
                .parallel()
                .mapToObj(tile -> tile(new Pair(one, other, tile), height))
                .toArray(Tile[]::new);
        RareLight rare =
                new RareLight(across, Arrays.stream(tiles).map(Tile::finds).toArray(Finds[]::new));
        return IntStream.range(0, count)
                .parallel()
                .mapToDouble(
                        tile -> tiles[tile].square() + square(rare.missing(tile), new Pair(one, other, tile), height))
                .map(Math::sqrt)
                .toArray();
    }

    /**
     * What the halves tell of a tile.
     *
     * @param square mean square of the standard errors of the pixels' display values
     */
    private record Tile(double square, Finds finds) {}

    /** Both halves of a tile. */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Pair(float[] ones, int firstSamples, float[] others, int secondSamples, int tile) {
        Pair(Half one, Half other, int tile) {
            this(
                    one.sums(),
                    one.samples().applyAsInt(tile),
                    other.sums(),
                    other.samples().applyAsInt(tile),
                    tile);
        }

        float first(int value) {
            return ones[value] / firstSamples;
        }

        float second(int value) {
            return others[value] / secondSamples;
        }

        /** The deviation of the mean of all samples, as a part of the halves' difference. */
        double part() {
            double all = firstSamples + secondSamples;
            return Math.sqrt(firstSamples / all * secondSamples / all);
        }
    }

    private Tile tile(Pair halves, int height) {
        int[] values = values(halves.tile(), height);
        double[] deviations = new double[values.length];
        double part = halves.part();
        double sum = 0;
        for (int i = 0; i < values.length; i++) {
            float first = halves.first(values[i]);
            float second = halves.second(values[i]);
            double shownFirst = shown(first);
            double shownSecond = shown(second);
            double difference = part * (shownFirst - shownSecond);
            sum += difference * difference;
            deviations[i] = Math.min(shownFirst, shownSecond) < WHITE ? part * Math.abs(first - second) : 0;
        }
        return new Tile(sum / values.length, Finds.of(deviations));
    }

    /** Mean square of what missing light changes in a tile. */
    private double square(double[] missing, Pair halves, int height) {
        if (missing[0] + missing[1] + missing[2] == 0) {
            return 0;
        }
        int[] values = values(halves.tile(), height);
        double sum = 0;
        for (int i = 0; i < values.length; i++) {
            float least = Math.min(halves.first(values[i]), halves.second(values[i]));
            double difference = shown(least + (float) missing[i % CHANNELS]) - shown(least);
            sum += difference * difference;
        }
        return sum / values.length;
    }

    /** Indices of a tile's values in the sums, pixel by pixel. */
    private int[] values(int tile, int height) {
        int across = Math.ceilDiv(width, BLOCK);
        int left = tile % across * BLOCK;
        int top = tile / across * BLOCK;
        int stride = CHANNELS * (Math.min(left + BLOCK, width) - left);
        int rows = Math.min(top + BLOCK, height) - top;
        int[] values = new int[stride * rows];
        for (int i = 0; i < values.length; i++) {
            values[i] = CHANNELS * ((top + i / stride) * width + left) + i % stride;
        }
        return values;
    }

    private float shown(float radiance) {
        return Tone.shown(radiance, frame[Layout.EXPOSURE_SCALE], (int) frame[Layout.TONE_MAP], frame[Layout.SRGB]);
    }
}
