package dev.twister.render;

import dev.twister.world.FrameInput;
import java.util.Optional;

/**
 * Which part of a picture is rendered.
 *
 * @param tile some of its rows; all where it is empty
 * @param samples some of each pixel's samples; the picture's own where it is empty
 */
public record PicturePart(Optional<Tile> tile, Optional<Samples> samples) {
    /** All of it. */
    public static final PicturePart WHOLE = new PicturePart(Optional.empty(), Optional.empty());

    /**
     * Some of a picture's rows.
     *
     * @param number from 1
     * @param count of tiles
     */
    public record Tile(int number, int count) {
        /** The first of its rows. */
        public int firstRow(int height) {
            return (int) ((number - 1L) * height / count);
        }

        /** How many rows it has. */
        public int rows(int height) {
            return (int) ((long) number * height / count) - firstRow(height);
        }
    }

    /** Samples of a sequence, both in it. */
    public record Samples(int first, int last) {
        public int count() {
            return last - first + 1;
        }
    }

    /** The part of a picture. */
    public FrameInput of(FrameInput input) {
        FrameInput sampled = samples.map(range -> input.withSamples(range.first(), range.count()))
                .orElse(input);
        int height = input.height();
        return tile.map(part -> sampled.band(part.firstRow(height), part.rows(height)))
                .orElse(sampled);
    }

    /** The samples of each pixel in words, as a number or a range. */
    Optional<String> samplesText() {
        return samples.map(range -> range.first() + "-" + range.last());
    }
}
