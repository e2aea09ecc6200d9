package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.image.Frame;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Writes a tile's pixels to the frame. */
public final class TileOutput {
    /** Selections from two blocks: the first two rows of each, side by side; and the last two. */
    private static final int[] ABOVE = {0, 1, 2, 3, 16, 17, 18, 19, 4, 5, 6, 7, 20, 21, 22, 23};

    private static final int[] BELOW = {8, 9, 10, 11, 24, 25, 26, 27, 12, 13, 14, 15, 28, 29, 30, 31};

    /** Selections from two such pairs: the first row of each, and the second row of each. */
    private static final int[] LOWER = {0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23};

    private static final int[] UPPER = {8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31};

    /** Swaps the two rows of half a block. */
    private static final int[] TURNED = {4, 5, 6, 7, 0, 1, 2, 3};

    private TileOutput() {}

    /** Tone maps the tile's colors, unless the frame is linear, and writes them. */
    public static void finish(Drawing drawing, Tile tile) {
        if (drawing.frame.isLinear()) {
            writeLinear(tile, drawing.frame, 1f / drawing.pixelSamples);
        } else {
            float[] values = drawing.input.view().frame();
            ToneLanes.map(tile, values, drawing.pixelSamples);
            ToneLanes.pack(tile, values, drawing.pixelSamples);
            write(tile, drawing.frame);
        }
    }

    /**
     * Prefetches the rows of the next tile in the frame, which a large frame pushes out of the caches. It reads the
     * last pixel of each row. The sum goes to an unused element before the tile's pixels, which keeps C2 from
     * eliminating the reads.
     */
    public static void approachNext(Tile tile, Frame frame) {
        int width = frame.width();
        if (!frame.isLinear() && tile.left + 2 * Tile.SIDE <= width && tile.top + Tile.SIDE <= frame.height()) {
            int[] argb = frame.argb();
            int sum = 0;
            int at = tile.top * width + tile.left + 2 * Tile.SIDE - 1;
            for (int row = 0; row < Tile.SIDE; row++) {
                sum += argb[at];
                at += width;
            }
            tile.argb[0] = sum;
        }
    }

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

    /**
     * Writes row by row of the frame, so that a cache line is written at once. A packet is a block of four rows, half a
     * block, or a row of a block.
     */
    private static void writeWhole(int[] tile, int[] frame, int first, int width) {
        int blocks = Lanes.BORDER;
        int end = first + Tile.SIDE * width;
        for (int to = first; to < end; to += Tile.BLOCK_SIDE * width) {
            switch (Lanes.COUNT) {
                case Tile.BLOCK -> writeBlocks(tile, blocks, frame, to, width);
                case Tile.BLOCK / 2 -> writeHalves(tile, blocks, frame, to, width);
                default -> writeRows(tile, blocks, frame, to, width);
            }
            blocks += Tile.SIDE * Tile.BLOCK_SIDE;
        }
    }

    private static void writeBlocks(int[] tile, int blocks, int[] frame, int first, int width) {
        IntVector above = IntVector.fromArray(Lanes.INTS, ABOVE, 0);
        IntVector below = IntVector.fromArray(Lanes.INTS, BELOW, 0);
        IntVector lower = IntVector.fromArray(Lanes.INTS, LOWER, 0);
        IntVector upper = IntVector.fromArray(Lanes.INTS, UPPER, 0);
        IntVector block0 = IntVector.fromArray(Lanes.INTS, tile, blocks);
        IntVector block1 = IntVector.fromArray(Lanes.INTS, tile, blocks + Tile.BLOCK);
        IntVector block2 = IntVector.fromArray(Lanes.INTS, tile, blocks + 2 * Tile.BLOCK);
        IntVector block3 = IntVector.fromArray(Lanes.INTS, tile, blocks + 3 * Tile.BLOCK);
        IntVector left = above.selectFrom(block0, block1);
        IntVector right = above.selectFrom(block2, block3);
        lower.selectFrom(left, right).intoArray(frame, first);
        upper.selectFrom(left, right).intoArray(frame, first + width);
        left = below.selectFrom(block0, block1);
        right = below.selectFrom(block2, block3);
        lower.selectFrom(left, right).intoArray(frame, first + 2 * width);
        upper.selectFrom(left, right).intoArray(frame, first + 3 * width);
    }

    /** Handles two blocks per step; each vector holds two rows of a block. */
    private static void writeHalves(int[] tile, int blocks, int[] frame, int first, int width) {
        IntVector turned = IntVector.fromArray(Lanes.INTS, TURNED, 0);
        VectorMask<Integer> behind = turned.compare(VectorOperators.LT, Tile.BLOCK_SIDE);
        for (int block = 0; block < Tile.SIDE / Tile.BLOCK_SIDE; block += 2) {
            for (int half = 0; half < 2; half++) {
                int from = blocks + block * Tile.BLOCK + half * Lanes.COUNT;
                int to = first + block * Tile.BLOCK_SIDE + half * 2 * width;
                IntVector left = IntVector.fromArray(Lanes.INTS, tile, from);
                IntVector right = IntVector.fromArray(Lanes.INTS, tile, from + Tile.BLOCK);
                left.blend(turned.selectFrom(right), behind).intoArray(frame, to);
                turned.selectFrom(left).blend(right, behind).intoArray(frame, to + width);
            }
        }
    }

    private static void writeRows(int[] tile, int blocks, int[] frame, int first, int width) {
        for (int row = 0; row < Tile.BLOCK_SIDE; row++) {
            for (int block = 0; block < Tile.SIDE / Tile.BLOCK_SIDE; block++) {
                IntVector.fromArray(Lanes.INTS, tile, blocks + block * Tile.BLOCK + row * Tile.BLOCK_SIDE)
                        .intoArray(frame, first + block * Tile.BLOCK_SIDE + row * width);
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

    /** Writes the linear colors, multiplied by {@code scale}. */
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
