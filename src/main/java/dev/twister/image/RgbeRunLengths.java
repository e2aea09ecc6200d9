package dev.twister.image;

import java.io.IOException;
import java.io.OutputStream;

/**
 * Radiance's newer run length code: after (2, 2, width / 256, width % 256) the four components of a scanline follow one
 * after the other, each in runs: n from 1 to 128 and n literal bytes, or 128 + n from 129 to 255 and a byte to repeat n
 * times.
 */
final class RgbeRunLengths {
    private static final int SHORTEST_WIDTH = 8;
    private static final int LONGEST_WIDTH = 32767;
    private static final int SHORTEST_RUN = 4;
    private static final int LONGEST_RUN = 127;
    private static final int LONGEST_LITERAL = 128;

    private final int width;
    private final byte[] component;

    RgbeRunLengths(int width) {
        this.width = width;
        this.component = new byte[width];
    }

    /** Whether scanlines of this width can be run length coded. */
    static boolean fits(int width) {
        return width >= SHORTEST_WIDTH && width <= LONGEST_WIDTH;
    }

    /** Writes one scanline of {@code 4 * width} bytes, texel by texel. */
    void write(byte[] scanline, OutputStream out) throws IOException {
        out.write(2);
        out.write(2);
        out.write(width >> 8);
        out.write(width);
        for (int channel = 0; channel < 4; channel++) {
            for (int x = 0; x < width; x++) {
                component[x] = scanline[4 * x + channel];
            }
            writeComponent(out);
        }
    }

    private void writeComponent(OutputStream out) throws IOException {
        int done = 0;
        int at = 0;
        while (at < width) {
            int run = runLength(at);
            if (run >= SHORTEST_RUN) {
                writeLiterals(done, at, out);
                out.write(128 + run);
                out.write(component[at]);
                done = at + run;
            }
            at += run;
        }
        writeLiterals(done, width, out);
    }

    private int runLength(int start) {
        int longest = Math.min(width - start, LONGEST_RUN);
        int run = 1;
        while (run < longest && component[start + run] == component[start]) {
            run++;
        }
        return run;
    }

    private void writeLiterals(int start, int end, OutputStream out) throws IOException {
        int at = start;
        while (at < end) {
            int count = Math.min(end - at, LONGEST_LITERAL);
            out.write(count);
            out.write(component, at, count);
            at += count;
        }
    }
}
