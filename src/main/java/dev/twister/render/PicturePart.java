package dev.twister.render;

import dev.twister.world.FrameInput;
import java.util.Optional;

/**
 * The part of a picture to render.
 *
 * @param tile rows to render; empty for all
 * @param samples samples of each pixel to render; empty for the picture's own number
 */
public record PicturePart(Optional<Tile> tile, Optional<Samples> samples) {
    /** The whole picture. */
    public static final PicturePart WHOLE = new PicturePart(Optional.empty(), Optional.empty());

    /**
     * A range of rows.
     *
     * @param number of the tile, from 1 at the top
     * @param count number of tiles of the picture
     */
    public record Tile(int number, int count) {
        /** Number of the first row. */
        public int firstRow(int height) {
            return (int) ((number - 1L) * height / count);
        }

        /** Number of rows. */
        public int rows(int height) {
            return (int) ((long) number * height / count) - firstRow(height);
        }
    }

    /**
     * Samples {@code first} to {@code last} of a pixel, both included, of a picture of an even number of samples. Those
     * are the items of the sequence after the pixel's center.
     */
    public record Samples(int first, int last) {
        public int count() {
            return last - first + 1;
        }
    }

    /** The input limited to this part. */
    public FrameInput of(FrameInput input) {
        FrameInput sampled = samples.map(range -> input.withSamples(1 + range.first(), range.count()))
                .orElse(input);
        int height = input.height();
        return tile.map(part -> sampled.band(part.firstRow(height), part.rows(height)))
                .orElse(sampled);
    }

    /** The range of samples as text. */
    Optional<String> samplesText() {
        return samples.map(range -> range.first() + "-" + range.last());
    }
}
