package dev.twister.sky.webp;

import dev.twister.sky.webp.Vp8Plane.Vp8Colors;
import java.io.IOException;
import java.util.Arrays;

/** Decodes a key frame of VP8 (RFC 6386). */
final class Vp8Frame {
    /** Tag, signature and size. */
    static final int HEADER_BYTES = 10;

    private static final int TAG_BYTES = 3;
    private static final int[] SIGNATURE = {0x9d, 0x01, 0x2a};
    private static final int BLOCKS = 16;

    /** The tree of block modes (section 11.2): a node's two branches, a mode where not positive. */
    private static final int[] MODES = {0, 1, -1, 2, -2, 3, 4, 6, -3, 5, -4, -5, -6, 7, -7, 8, -8, -9};

    private final int width;
    private final int height;
    private final int columns;
    private final int rows;
    private final Vp8Bits bits;
    private final Vp8Header header;
    private final Vp8Bits[] partitions;
    private final Vp8Plane luma;
    private final Vp8Plane u;
    private final Vp8Plane v;
    private final Vp8Coefficients coefficients;

    /** Modes of the blocks at the bottom of the row above, and at the right of the macroblock to the left. */
    private final int[] modesAbove;

    private final int[] modesLeft = new int[4];
    private final int[] modes = new int[BLOCKS];
    private final Vp8Header.Strength[] strengths;
    private final Vp8Header.Strength[] blockStrengths;

    private Vp8Frame(byte[] data, int from, int to) throws IOException {
        int tag = number(data, from, 3);
        WebpDamage.check((tag & 1) == 0 && (tag >> 1 & 7) <= 3, "no key frame of VP8");
        WebpDamage.check((tag >> 4 & 1) == 1, "a frame that is not shown");
        for (int i = 0; i < SIGNATURE.length; i++) {
            WebpDamage.check((data[from + TAG_BYTES + i] & 0xff) == SIGNATURE[i], "no VP8 frame");
        }
        width = number(data, from + 6, 2) & 0x3fff;
        height = number(data, from + 8, 2) & 0x3fff;
        columns = (width + 15) >> 4;
        rows = (height + 15) >> 4;
        int first = from + HEADER_BYTES;
        int rest = first + (tag >>> 5);
        if (rest > to) {
            throw WebpDamage.truncated();
        }
        bits = new Vp8Bits(data, first, rest);
        header = new Vp8Header(bits);
        partitions = partitions(data, rest, to, header.partitions());
        luma = new Vp8Plane(16 * columns, 16 * rows);
        u = new Vp8Plane(8 * columns, 8 * rows);
        v = new Vp8Plane(8 * columns, 8 * rows);
        coefficients = new Vp8Coefficients(header.probabilities(), columns);
        modesAbove = new int[4 * columns];
        strengths = header.strengths(false);
        blockStrengths = header.strengths(true);
    }

    /** The texels of a frame, opaque. */
    static int[] decode(byte[] data, int from, int to) throws IOException {
        Vp8Frame frame = new Vp8Frame(data, from, to);
        frame.read();
        return Vp8Colors.argb(frame.luma, frame.u, frame.v, frame.width, frame.height);
    }

    private static int number(byte[] data, int at, int bytes) {
        int number = 0;
        for (int i = 0; i < bytes; i++) {
            number |= (data[at + i] & 0xff) << (8 * i);
        }
        return number;
    }

    private static Vp8Bits[] partitions(byte[] data, int from, int to, int count) throws IOException {
        Vp8Bits[] partitions = new Vp8Bits[count];
        int start = from + 3 * (count - 1);
        if (start >= to) {
            throw WebpDamage.truncated();
        }
        for (int i = 0; i < count; i++) {
            int end = i == count - 1 ? to : Math.min(to, start + number(data, from + 3 * i, 3));
            partitions[i] = new Vp8Bits(data, start, end);
            start = end;
        }
        return partitions;
    }

    /** A macroblock's filter. */
    private record Filter(Vp8Header.Strength strength, boolean inner) {}

    private void read() throws IOException {
        Filter[][] filters = new Filter[rows][columns];
        for (int row = 0; row < rows; row++) {
            Arrays.fill(modesLeft, 0);
            coefficients.startRow();
            for (int column = 0; column < columns; column++) {
                filters[row][column] = macroblock(column, row);
            }
        }
        // Only now, as prediction is from unfiltered values.
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                filter(filters[row][column], column, row);
            }
        }
    }

    private Filter macroblock(int column, int row) throws IOException {
        int segment = header.segment();
        boolean skip = header.skips();
        boolean whole = bits.bit(145) == 1;
        int mode = whole ? wholeMode(column) : blockModes(column);
        int chromaMode = chromaMode();
        if (skip) {
            coefficients.skip(column, whole);
        } else {
            coefficients.read(partitions[row & partitions.length - 1], column, whole, header.factors(segment));
        }
        short[] values = coefficients.values();
        if (whole) {
            Vp8Prediction.macroblock(luma, column, row, 16, mode);
            for (int block = 0; block < BLOCKS; block++) {
                luma.addTransformed(values, 16 * block, blockAt(column, row, block));
            }
        } else {
            blocks(column, row, values);
        }
        chroma(u, column, row, chromaMode, 16 * 16);
        chroma(v, column, row, chromaMode, 20 * 16);
        Vp8Header.Strength strength = (whole ? strengths : blockStrengths)[segment];
        return new Filter(strength, !whole || coefficients.any());
    }

    private int blockAt(int column, int row, int block) {
        return luma.at(16 * column + 4 * (block & 3), 16 * row + 4 * (block >> 2));
    }

    private void blocks(int column, int row, short[] values) {
        int[] right = new int[4];
        for (int block = 0; block < BLOCKS; block++) {
            int start = blockAt(column, row, block);
            // Blocks at the right have their neighbors from the macroblock above.
            int above = luma.at(16 * column + 4 * (block & 3) + 4, 16 * row - 1 + ((block & 3) == 3 ? 0 : block & 12));
            for (int i = 0; i < right.length; i++) {
                right[i] = (block & 3) < 3 || column < columns - 1 ? luma.value(above + i) : beyond(column, row);
            }
            Vp8Prediction.block(luma, start, modes[block], right);
            luma.addTransformed(values, 16 * block, start);
        }
    }

    /** What stands for values above and beyond the right border, as libwebp has it. */
    private int beyond(int column, int row) {
        return luma.value(luma.at(16 * column + 15, 16 * row - 1));
    }

    private void chroma(Vp8Plane plane, int column, int row, int mode, int first) {
        Vp8Prediction.macroblock(plane, column, row, 8, mode);
        for (int block = 0; block < 4; block++) {
            int to = plane.at(8 * column + 4 * (block & 1), 8 * row + 4 * (block >> 1));
            plane.addTransformed(coefficients.values(), first + 16 * block, to);
        }
    }

    private int wholeMode(int column) throws IOException {
        int mode;
        if (bits.bit(156) == 1) {
            mode = bits.flag() ? Vp8Prediction.TRUE_MOTION : Vp8Prediction.HORIZONTAL;
        } else {
            mode = bits.bit(163) == 1 ? Vp8Prediction.VERTICAL : Vp8Prediction.MEAN;
        }
        Arrays.fill(modesAbove, 4 * column, 4 * column + 4, mode);
        Arrays.fill(modesLeft, mode);
        return mode;
    }

    private int blockModes(int column) throws IOException {
        for (int block = 0; block < BLOCKS; block++) {
            int above = 4 * column + (block & 3);
            int beside = block >> 2;
            int node = 0;
            do {
                int probability = Vp8Tables.modeProbability(modesAbove[above], modesLeft[beside], node);
                node = MODES[2 * node + bits.bit(probability)];
            } while (node > 0);
            modes[block] = -node;
            modesAbove[above] = -node;
            modesLeft[beside] = -node;
        }
        return 0;
    }

    private int chromaMode() throws IOException {
        if (bits.bit(142) == 0) {
            return Vp8Prediction.MEAN;
        }
        if (bits.bit(114) == 0) {
            return Vp8Prediction.VERTICAL;
        }
        return bits.bit(183) == 1 ? Vp8Prediction.TRUE_MOTION : Vp8Prediction.HORIZONTAL;
    }

    private void filter(Filter filter, int column, int row) {
        Vp8Header.Strength strength = filter.strength();
        if (strength.limit() == 0) {
            return;
        }
        if (header.isSimpleFilter()) {
            Vp8LoopFilter.simple(luma, column, row, strength.limit(), filter.inner());
        } else {
            Vp8LoopFilter.normal(luma, column, row, 16, strength, filter.inner());
            Vp8LoopFilter.normal(u, column, row, 8, strength, filter.inner());
            Vp8LoopFilter.normal(v, column, row, 8, strength, filter.inner());
        }
    }
}
