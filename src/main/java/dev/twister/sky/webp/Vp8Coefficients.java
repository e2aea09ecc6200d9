package dev.twister.sky.webp;

import java.io.IOException;
import java.util.Arrays;

/** Reads the coefficients of macroblocks (RFC 6386, section 13 and 14.3). */
final class Vp8Coefficients {
    private static final int LUMA_WITHOUT_MEAN = 0;
    private static final int LUMA_MEANS = 1;
    private static final int CHROMA = 2;
    private static final int LUMA = 3;

    private static final int[] BANDS = {0, 1, 2, 3, 6, 4, 5, 6, 6, 6, 6, 6, 6, 6, 6, 7, 0};
    private static final int[] ZIGZAG = {0, 1, 4, 8, 5, 2, 3, 6, 9, 12, 13, 10, 7, 11, 14, 15};
    private static final int[][] LARGE = {
        {173, 148, 140},
        {176, 155, 140, 135},
        {180, 157, 141, 134, 130},
        {254, 254, 243, 230, 196, 177, 153, 140, 133, 130, 129}
    };

    /** Blocks of a macroblock: 16 of luma, 4 of each chroma. */
    private static final int BLOCKS = 24;

    private static final int SIZE = 16;

    /** Blocks in a row of luma, U and V above, and in a column to the left, that had coefficients; and the means. */
    private static final int CONTEXTS = 9;

    private static final int U_CONTEXT = 4;
    private static final int V_CONTEXT = 6;
    private static final int[] FIRST_BLOCKS = {0, 0, 16, 20};

    private final int[] probabilities;
    private final boolean[] above;
    private final boolean[] left = new boolean[CONTEXTS];
    private final short[] values = new short[BLOCKS * SIZE];
    private final short[] means = new short[SIZE];
    private boolean any;

    Vp8Coefficients(int[] probabilities, int columns) {
        this.probabilities = probabilities;
        this.above = new boolean[columns * CONTEXTS];
    }

    /** The 16 values of each block of the last macroblock, multiplied by their factors. */
    short[] values() {
        return values;
    }

    /** Whether the last macroblock has values other than 0, or as if it had. */
    boolean any() {
        return any;
    }

    void startRow() {
        Arrays.fill(left, false);
    }

    /** A macroblock without coefficients. */
    void skip(int column, boolean hasMeans) {
        for (int i = 0; i < CONTEXTS - (hasMeans ? 0 : 1); i++) {
            above[column * CONTEXTS + i] = false;
            left[i] = false;
        }
        Arrays.fill(values, (short) 0);
        any = false;
    }

    /** Reads a macroblock. */
    void read(Vp8Bits bits, int column, boolean hasMeans, Vp8Header.Factors factors) throws IOException {
        Arrays.fill(values, (short) 0);
        any = false;
        int first = column * CONTEXTS;
        int kind = LUMA;
        if (hasMeans) {
            kind = LUMA_WITHOUT_MEAN;
            Arrays.fill(means, (short) 0);
            int context = context(first + CONTEXTS - 1, CONTEXTS - 1);
            int end = block(bits, LUMA_MEANS, context, 0, factors.lumaMeanDc(), factors.lumaMeanAc(), means, 0);
            above[first + CONTEXTS - 1] = end > 0;
            left[CONTEXTS - 1] = end > 0;
            spreadMeans();
        }
        int start = hasMeans ? 1 : 0;
        plane(bits, kind, start, first, 0, factors.lumaDc(), factors.lumaAc());
        plane(bits, CHROMA, 0, first, U_CONTEXT, factors.chromaDc(), factors.chromaAc());
        plane(bits, CHROMA, 0, first, V_CONTEXT, factors.chromaDc(), factors.chromaAc());
    }

    private int context(int aboveIndex, int leftIndex) {
        return (above[aboveIndex] ? 1 : 0) + (left[leftIndex] ? 1 : 0);
    }

    private void plane(Vp8Bits bits, int kind, int start, int first, int context, int dc, int ac) throws IOException {
        int side = kind == CHROMA ? 2 : 4;
        int block = FIRST_BLOCKS[context / 2];
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                int up = first + context + x;
                int beside = context + y;
                int at = (block + y * side + x) * SIZE;
                int end = block(bits, kind, context(up, beside), start, dc, ac, values, at);
                any |= end > 1 || values[at] != 0;
                above[up] = end > start;
                left[beside] = end > start;
            }
        }
    }

    /** Reads a block's values; returns where they end. */
    private int block(Vp8Bits bits, int kind, int context, int start, int dc, int ac, short[] target, int at)
            throws IOException {
        int n = start;
        int p = place(kind, n, context);
        while (n < SIZE) {
            if (bits.bit(probabilities[p]) == 0) {
                return n;
            }
            while (bits.bit(probabilities[p + 1]) == 0) {
                n++;
                if (n == SIZE) {
                    return SIZE;
                }
                p = place(kind, n, 0);
            }
            int magnitude = 1;
            if (bits.bit(probabilities[p + 2]) == 1) {
                magnitude = large(bits, p);
            }
            target[at + ZIGZAG[n]] = (short) (bits.signed(magnitude) * (n > 0 ? ac : dc));
            n++;
            p = place(kind, n, magnitude > 1 ? 2 : 1);
        }
        return SIZE;
    }

    private static int place(int kind, int n, int context) {
        return ((kind * Vp8Tables.BANDS + BANDS[n]) * Vp8Tables.CONTEXTS + context) * Vp8Tables.TOKENS;
    }

    private int large(Vp8Bits bits, int p) throws IOException {
        if (bits.bit(probabilities[p + 3]) == 0) {
            return bits.bit(probabilities[p + 4]) == 0 ? 2 : 3 + bits.bit(probabilities[p + 5]);
        }
        if (bits.bit(probabilities[p + 6]) == 0) {
            if (bits.bit(probabilities[p + 7]) == 0) {
                return 5 + bits.bit(159);
            }
            int high = bits.bit(165);
            return 7 + 2 * high + bits.bit(145);
        }
        int high = bits.bit(probabilities[p + 8]);
        int category = 2 * high + bits.bit(probabilities[p + 9 + high]);
        int extra = 0;
        for (int probability : LARGE[category]) {
            extra = 2 * extra + bits.bit(probability);
        }
        return 3 + (8 << category) + extra;
    }

    /** The inverse Walsh-Hadamard transform of the means, into the blocks of luma. */
    private void spreadMeans() {
        int[] rows = new int[SIZE];
        for (int i = 0; i < 4; i++) {
            int a = means[i] + means[12 + i];
            int b = means[4 + i] + means[8 + i];
            int c = means[4 + i] - means[8 + i];
            int d = means[i] - means[12 + i];
            rows[i] = a + b;
            rows[4 + i] = d + c;
            rows[8 + i] = a - b;
            rows[12 + i] = d - c;
        }
        for (int i = 0; i < SIZE; i += 4) {
            int rounded = rows[i] + 3;
            int a = rounded + rows[i + 3];
            int b = rows[i + 1] + rows[i + 2];
            int c = rows[i + 1] - rows[i + 2];
            int d = rounded - rows[i + 3];
            values[i * SIZE] = (short) ((a + b) >> 3);
            values[(i + 1) * SIZE] = (short) ((d + c) >> 3);
            values[(i + 2) * SIZE] = (short) ((a - b) >> 3);
            values[(i + 3) * SIZE] = (short) ((d - c) >> 3);
        }
    }
}
