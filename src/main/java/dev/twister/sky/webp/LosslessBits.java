package dev.twister.sky.webp;

import java.io.IOException;

/** The bits of a VP8L stream, the lowest of each byte first. */
final class LosslessBits {
    private static final int MOST_PEEKED = 16;

    private final byte[] data;
    private final int end;
    private int at;
    private long window;
    private int held;

    LosslessBits(byte[] data, int from, int to) {
        this.data = data;
        this.at = from;
        this.end = to;
    }

    /** The next bits without taking them; zeros beyond the end. */
    int peek() {
        while (held < MOST_PEEKED && at < end) {
            window |= (data[at++] & 0xffL) << held;
            held += Byte.SIZE;
        }
        return (int) window & 0xffff;
    }

    /** Takes bits that {@link #peek} has shown. */
    void take(int bits) throws IOException {
        if (bits > held) {
            throw WebpDamage.truncated();
        }
        window >>>= bits;
        held -= bits;
    }

    /** The number in the next bits, of which there may be 24. */
    int read(int bits) throws IOException {
        int low = Math.min(bits, MOST_PEEKED);
        int number = peek() & (1 << low) - 1;
        take(low);
        if (bits > low) {
            number |= (peek() & (1 << (bits - low)) - 1) << low;
            take(bits - low);
        }
        return number;
    }

    boolean flag() throws IOException {
        return read(1) == 1;
    }
}
