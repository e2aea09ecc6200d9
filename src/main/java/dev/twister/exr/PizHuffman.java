package dev.twister.exr;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.zip.DataFormatException;

/** The Huffman code of PIZ: canonical, of up to 58 bits, the highest bit first, longer codes with lower numbers. */
final class PizHuffman {
    private static final int SYMBOLS = (1 << 16) + 1;
    private static final int LONGEST = 58;
    private static final int LENGTH_BITS = 6;
    private static final int SHORT_RUN = 59;
    private static final int LONG_RUN = 63;
    private static final int SHORTEST_LONG_RUN = 2 + LONG_RUN - SHORT_RUN;
    private static final int LOOKUP_BITS = 12;

    private final byte[] data;
    private final long end;
    private long position;

    /** By the next bits: a symbol and the length of its code; 0 if that is longer. */
    private final int[] lookup = new int[1 << LOOKUP_BITS];

    private final long[] firstCode = new long[LONGEST + 1];
    private final int[] counts = new int[LONGEST + 1];
    private final int[] firstIndex = new int[LONGEST + 1];
    private final int[] sorted;

    private PizHuffman(byte[] data, long position, long end, int[] lengths) throws DataFormatException {
        this.data = data;
        this.position = position;
        this.end = end;
        for (int length : lengths) {
            counts[length]++;
        }
        counts[0] = 0;
        long code = 0;
        int index = 0;
        for (int length = LONGEST; length > 0; length--) {
            firstCode[length] = code;
            ExrChunkDecoder.check(code + counts[length] <= 1L << length);
            code = (code + counts[length]) >> 1;
        }
        for (int length = 1; length <= LONGEST; length++) {
            firstIndex[length] = index;
            index += counts[length];
        }
        sorted = sorted(lengths, index);
        fillLookup();
    }

    private int[] sorted(int[] lengths, int used) {
        int[] symbols = new int[used];
        int[] next = firstIndex.clone();
        for (int symbol = 0; symbol < lengths.length; symbol++) {
            if (lengths[symbol] > 0) {
                symbols[next[lengths[symbol]]++] = symbol;
            }
        }
        return symbols;
    }

    private void fillLookup() {
        for (int length = 1; length <= LOOKUP_BITS; length++) {
            for (int i = 0; i < counts[length]; i++) {
                int from = (int) (firstCode[length] + i) << (LOOKUP_BITS - length);
                int entry = sorted[firstIndex[length] + i] << LENGTH_BITS | length;
                Arrays.fill(lookup, from, from + (1 << (LOOKUP_BITS - length)), entry);
            }
        }
    }

    /** Decodes values. */
    static void decode(ByteBuffer in, short[] values) throws DataFormatException {
        int first = in.getInt();
        int last = in.getInt();
        in.getInt();
        int bits = in.getInt();
        in.getInt();
        ExrChunkDecoder.check(first >= 0 && first <= last && last < SYMBOLS && bits >= 0);
        byte[] data = new byte[in.remaining()];
        in.get(data);
        int[] lengths = new int[SYMBOLS];
        long start = lengths(data, first, last, lengths);
        ExrChunkDecoder.check(start + bits <= (long) Byte.SIZE * data.length);
        new PizHuffman(data, start, start + bits, lengths).decode(last, values);
    }

    /** Reads the lengths of codes; returns the bit from which on values follow. */
    private static long lengths(byte[] data, int first, int last, int[] lengths) throws DataFormatException {
        long at = 0;
        int symbol = first;
        while (symbol <= last) {
            int length = bits(data, at, LENGTH_BITS);
            at += LENGTH_BITS;
            if (length < SHORT_RUN) {
                lengths[symbol++] = length;
            } else {
                int run = length - SHORT_RUN + 2;
                if (length == LONG_RUN) {
                    run = bits(data, at, Byte.SIZE) + SHORTEST_LONG_RUN;
                    at += Byte.SIZE;
                }
                symbol += run;
                ExrChunkDecoder.check(symbol <= last + 1);
            }
        }
        return Math.ceilDiv(at, Byte.SIZE) * Byte.SIZE;
    }

    /** Up to 16 bits; zeros beyond the end. */
    private static int bits(byte[] data, long position, int count) {
        int at = (int) (position / Byte.SIZE);
        int three = 0;
        for (int i = at; i < at + 3; i++) {
            three = three << Byte.SIZE | (i < data.length ? data[i] & 0xff : 0);
        }
        return three >> (3 * Byte.SIZE - count - (int) (position % Byte.SIZE)) & (1 << count) - 1;
    }

    private void decode(int runSymbol, short[] values) throws DataFormatException {
        int at = 0;
        while (at < values.length) {
            int symbol = next();
            if (symbol == runSymbol) {
                ExrChunkDecoder.check(at > 0 && position + Byte.SIZE <= end);
                int run = bits(data, position, Byte.SIZE);
                position += Byte.SIZE;
                ExrChunkDecoder.check(run <= values.length - at);
                Arrays.fill(values, at, at + run, values[at - 1]);
                at += run;
            } else {
                values[at++] = (short) symbol;
            }
        }
    }

    private int next() throws DataFormatException {
        int entry = lookup[bits(data, position, LOOKUP_BITS)];
        int length = entry & (1 << LENGTH_BITS) - 1;
        int symbol = entry >> LENGTH_BITS;
        if (length == 0) {
            long code = bits(data, position, LOOKUP_BITS);
            length = LOOKUP_BITS;
            do {
                length++;
                ExrChunkDecoder.check(length <= LONGEST);
                code = code << 1 | bits(data, position + length - 1, 1);
            } while (code < firstCode[length] || code - firstCode[length] >= counts[length]);
            symbol = sorted[firstIndex[length] + (int) (code - firstCode[length])];
        }
        position += length;
        ExrChunkDecoder.check(position <= end);
        return symbol;
    }
}
