package dev.twister.sky.webp;

import java.io.IOException;

/** The boolean entropy decoder of VP8 (RFC 6386, section 7). */
final class Vp8Bits {
    private final byte[] data;
    private final int end;
    private int at;
    private int value;
    private int range = 254;

    /** Bits of the value beyond the eight that are compared; negative before more are needed. */
    private int spare = -Byte.SIZE;

    Vp8Bits(byte[] data, int from, int to) {
        this.data = data;
        this.at = from;
        this.end = to;
    }

    /**
     * The next boolean.
     *
     * @param probability that it is 0, of 256
     * @throws IOException if the data ends before it
     */
    int bit(int probability) throws IOException {
        if (spare < 0) {
            load();
        }
        int split = (range * probability) >> 8;
        int bit = 0;
        if (value >> spare > split) {
            range -= split + 1;
            value -= (split + 1) << spare;
            bit = 1;
        } else {
            range = split;
        }
        int shift = Integer.numberOfLeadingZeros(range + 1) - 24;
        if (shift > 0) {
            range = ((range + 1) << shift) - 1;
            spare -= shift;
        }
        return bit;
    }

    private void load() throws IOException {
        if (at >= end) {
            throw WebpDamage.truncated();
        }
        value = value << Byte.SIZE | (data[at++] & 0xff);
        spare += Byte.SIZE;
    }

    boolean flag() throws IOException {
        return bit(128) == 1;
    }

    /** An unsigned number, the highest bit first. */
    int number(int bits) throws IOException {
        int number = 0;
        for (int i = 0; i < bits; i++) {
            number = number << 1 | bit(128);
        }
        return number;
    }

    /** A number and its sign where a flag says that there is one; else 0. */
    int optionalSigned(int bits) throws IOException {
        return flag() ? signed(number(bits)) : 0;
    }

    /** Applies the sign in the next bit. */
    int signed(int magnitude) throws IOException {
        return flag() ? -magnitude : magnitude;
    }
}
