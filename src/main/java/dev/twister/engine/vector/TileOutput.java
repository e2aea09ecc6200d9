package dev.twister.engine.vector;

import dev.twister.image.Frame;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorSpecies;

/** Puts a tile's pixels where they belong in the frame. */
final class TileOutput {
    /** One row of a block. */
    private static final VectorSpecies<Integer> BLOCK_ROW = IntVector.SPECIES_128;

    private TileOutput() {}

    /** Writes the packed pixels. */
    static void write(Tile tile, Frame frame) {
        int left = tile.left;
        int top = tile.top;
        boolean whole = left + Tile.SIDE <= frame.width() && top + Tile.SIDE <= frame.height();
        if (whole) {
            writeWhole(tile.argb, frame.argb(), top * frame.width() + left, frame.width());
        } else {
            writePart(tile, frame);
        }
    }

    /** Row by row of the frame, so that what goes to one cache line goes there at once. */
    private static void writeWhole(int[] tile, int[] frame, int first, int width) {
        int to = first;
        int end = Lanes.BORDER + Tile.SIZE;
        for (int blocks = Lanes.BORDER; blocks < end; blocks += Tile.SIDE * Tile.BLOCK_SIDE) {
            for (int from = blocks; from < blocks + Tile.BLOCK; from += Tile.BLOCK_SIDE) {
                for (int block = 0; block < Tile.SIDE / Tile.BLOCK_SIDE; block++) {
                    IntVector.fromArray(BLOCK_ROW, tile, from + block * Tile.BLOCK)
                            .intoArray(frame, to + block * Tile.BLOCK_SIDE);
                }
                to += width;
            }
        }
    }

    private static void writePart(Tile tile, Frame frame) {
        for (int pixel = 0; pixel < Tile.SIZE; pixel++) {
            int x = tile.left + Tile.column(pixel);
            int y = tile.top + Tile.row(pixel);
            if (x < frame.width() && y < frame.height()) {
                frame.argb()[y * frame.width() + x] = tile.argb[Lanes.BORDER + pixel];
            }
        }
    }

    /** Writes the linear colours, times {@code scale}. */
    static void writeLinear(Tile tile, Frame frame, float scale) {
        float[] t = tile.values;
        for (int pixel = 0; pixel < Tile.SIZE; pixel++) {
            int x = tile.left + Tile.column(pixel);
            int y = tile.top + Tile.row(pixel);
            if (x < frame.width() && y < frame.height()) {
                int to = 3 * (y * frame.width() + x);
                frame.radiance()[to] = t[pixel + Tile.RED] * scale;
                frame.radiance()[to + 1] = t[pixel + Tile.GREEN] * scale;
                frame.radiance()[to + 2] = t[pixel + Tile.BLUE] * scale;
            }
        }
    }
}
