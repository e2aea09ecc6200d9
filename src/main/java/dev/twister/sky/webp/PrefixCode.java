package dev.twister.sky.webp;

import java.io.IOException;
import java.util.Arrays;

/** A prefix code of VP8L (RFC 9649, section 3.7.2). */
final class PrefixCode {
    private static final int LONGEST = 15;
    private static final int LOOKUP_BITS = 8;
    private static final int LENGTH_BITS = 4;
    private static final int LENGTH_SYMBOLS = 19;
    private static final int REPEAT = 16;
    private static final int[] ORDER = {17, 18, 0, 1, 2, 3, 4, 5, 16, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    private static final int[] REPEAT_BITS = {2, 3, 7};
    private static final int[] REPEAT_OFFSET = {3, 3, 11};

    /** By the next bits: symbol and length of its code; 0 where that is longer than the lookup. */
    private final short[] lookup;

    private final int lookupMask;
    private final int[] counts;
    private final short[] sorted;

    private PrefixCode(short[] lookup, int[] counts, short[] sorted) {
        this.lookup = lookup;
        this.lookupMask = lookup.length - 1;
        this.counts = counts;
        this.sorted = sorted;
    }

    /** Reads a code for an alphabet. */
    static PrefixCode read(LosslessBits bits, int symbols) throws IOException {
        int[] lengths;
        if (bits.flag()) {
            boolean two = bits.flag();
            int first = bits.read(bits.flag() ? 8 : 1);
            int second = two ? bits.read(8) : first;
            WebpDamage.check(Math.max(first, second) < symbols, "a symbol of no alphabet");
            lengths = new int[Math.max(first, second) + 1];
            lengths[first] = 1;
            lengths[second] = 1;
        } else {
            lengths = lengths(bits, symbols);
        }
        return of(lengths);
    }

    private static int[] lengths(LosslessBits bits, int symbols) throws IOException {
        int[] lengthLengths = new int[LENGTH_SYMBOLS];
        int given = bits.read(4) + 4;
        for (int i = 0; i < given; i++) {
            lengthLengths[ORDER[i]] = bits.read(3);
        }
        PrefixCode code = of(lengthLengths);
        int left = symbols;
        if (bits.flag()) {
            left = 2 + bits.read(2 + 2 * bits.read(3));
            WebpDamage.check(left <= symbols, "more code lengths than symbols");
        }
        int[] lengths = new int[symbols];
        int previous = 8;
        int symbol = 0;
        while (symbol < symbols && left-- > 0) {
            int length = code.next(bits);
            if (length < REPEAT) {
                lengths[symbol++] = length;
                previous = length == 0 ? previous : length;
            } else {
                int kind = length - REPEAT;
                int repeat = bits.read(REPEAT_BITS[kind]) + REPEAT_OFFSET[kind];
                WebpDamage.check(symbol + repeat <= symbols, "more code lengths than symbols");
                Arrays.fill(lengths, symbol, symbol + repeat, kind == 0 ? previous : 0);
                symbol += repeat;
            }
        }
        return lengths;
    }

    /** The canonical code of given lengths, one per symbol, 0 for symbols that it does not have. */
    private static PrefixCode of(int[] lengths) throws IOException {
        int[] counts = new int[LONGEST + 1];
        for (int length : lengths) {
            counts[length]++;
        }
        int used = lengths.length - counts[0];
        WebpDamage.check(used > 0, "a code without symbols");
        counts[0] = 0;
        short[] sorted = sorted(lengths, counts, used);
        if (used == 1) {
            return new PrefixCode(new short[] {(short) (sorted[0] << LENGTH_BITS)}, counts, sorted);
        }
        int open = 1;
        int longest = 0;
        for (int length = 1; length <= LONGEST; length++) {
            open = 2 * open - counts[length];
            WebpDamage.check(open >= 0, "a code with too many symbols");
            longest = counts[length] > 0 ? length : longest;
        }
        WebpDamage.check(open == 0, "a code with too few symbols");
        return new PrefixCode(lookup(counts, sorted, Math.min(longest, LOOKUP_BITS)), counts, sorted);
    }

    /** The symbols by length, then by number. */
    private static short[] sorted(int[] lengths, int[] counts, int used) {
        int[] starts = new int[LONGEST + 2];
        for (int length = 1; length <= LONGEST; length++) {
            starts[length + 1] = starts[length] + counts[length];
        }
        short[] sorted = new short[used];
        for (int symbol = 0; symbol < lengths.length; symbol++) {
            if (lengths[symbol] > 0) {
                sorted[starts[lengths[symbol]]++] = (short) symbol;
            }
        }
        return sorted;
    }

    private static short[] lookup(int[] counts, short[] sorted, int bits) {
        short[] lookup = new short[1 << bits];
        int code = 0;
        int index = 0;
        for (int length = 1; length <= bits; length++) {
            code <<= 1;
            for (int i = 0; i < counts[length]; i++) {
                int reversed = Integer.reverse(code++) >>> (Integer.SIZE - length);
                short entry = (short) (sorted[index++] << LENGTH_BITS | length);
                for (int at = reversed; at < lookup.length; at += 1 << length) {
                    lookup[at] = entry;
                }
            }
        }
        return lookup;
    }

    /** Whether there is one symbol, of no bits. */
    boolean isSingle() {
        return sorted.length == 1;
    }

    /** The next symbol. */
    int next(LosslessBits bits) throws IOException {
        int peeked = bits.peek();
        int entry = lookup[peeked & lookupMask] & 0xffff;
        int length = entry & (1 << LENGTH_BITS) - 1;
        if (length > 0 || isSingle()) {
            bits.take(length);
            return entry >> LENGTH_BITS;
        }
        int code = 0;
        int first = 0;
        int index = 0;
        for (length = 1; length <= LONGEST; length++) {
            code |= peeked >> (length - 1) & 1;
            if (code - first < counts[length]) {
                bits.take(length);
                return sorted[index + code - first];
            }
            index += counts[length];
            first = (first + counts[length]) << 1;
            code <<= 1;
        }
        throw WebpDamage.damaged("a code of no symbol");
    }
}
