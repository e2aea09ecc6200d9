package dev.twister.sky.radiance;

import dev.twister.sky.image.FileBytes.FileCursor;
import java.io.IOException;

/**
 * Reads the scanlines of a Radiance picture in any mix of the three codings: flat texels; the old run lengths, texels
 * (1, 1, 1, n) that repeat the one before, each following one directly counting 256 times as much; and the new ones,
 * which start with (2, 2, length / 256, length % 256) and code the four components one after the other.
 */
final class RadianceScanlines {
    private static final int SHORTEST_NEW = 8;
    private static final int LONGEST_NEW = 32767;
    private static final int LARGEST_SHIFT = 24;

    /** A code of this many and fewer is followed by as many values; one above it by one that is repeated. */
    private static final int LONGEST_LITERAL = 128;

    private final FileCursor content;
    private final int length;
    private final byte[] values = new byte[LONGEST_LITERAL];

    /** Scanlines of {@code length} texels, read from the cursor's position on. */
    RadianceScanlines(FileCursor content, int length) {
        this.content = content;
        this.length = length;
    }

    /** The fewest bytes a scanline of this length takes, flat or in new run lengths. */
    static long fewestBytesWithoutOldRuns(int length) {
        long flat = 4L * length;
        long newRuns = 4 + 8L * Math.ceilDiv(length, 127);
        return mayBeNew(length) ? Math.min(flat, newRuns) : flat;
    }

    /**
     * The fewest bytes a scanline of this length takes in any coding: a texel, then old runs of up to 255, 65535, ...
     */
    static long fewestBytes(int length) {
        long oldRuns = 4;
        for (long covered = 1; covered < length; covered = covered * 256) {
            oldRuns += 4;
        }
        return Math.min(oldRuns, fewestBytesWithoutOldRuns(length));
    }

    /** Reads the next scanline into {@code 4 * length} bytes, texel by texel. */
    void next(byte[] scanline) throws IOException {
        byte[] first = new byte[4];
        take(first, 0, 4);
        if (mayBeNew(length) && first[0] == 2 && first[1] == 2 && first[2] >= 0) {
            int claimed = first[2] << 8 | Byte.toUnsignedInt(first[3]);
            if (claimed != length) {
                throw new IOException("a scanline of " + claimed + " texels where the resolution line says " + length);
            }
            for (int component = 0; component < 4; component++) {
                newRuns(scanline, component);
            }
        } else {
            System.arraycopy(first, 0, scanline, 0, 4);
            if (isOldRun(scanline, 0)) {
                throw new IOException("a run at the start of a scanline, with no texel before it to repeat");
            }
            flatAndOldRuns(scanline);
        }
    }

    private static boolean mayBeNew(int length) {
        return length >= SHORTEST_NEW && length <= LONGEST_NEW;
    }

    private void newRuns(byte[] scanline, int component) throws IOException {
        int done = 0;
        while (done < length) {
            int code = takeByte();
            boolean run = code > LONGEST_LITERAL;
            int count = run ? code - LONGEST_LITERAL : code;
            if (count == 0) {
                throw new IOException("zero-length run in scanline");
            }
            checkFits(count, done);
            int different = run ? 1 : count;
            take(values, 0, different);
            for (int i = 0; i < count; i++) {
                scanline[4 * (done + i) + component] = values[run ? 0 : i];
            }
            done += count;
        }
    }

    private void flatAndOldRuns(byte[] scanline) throws IOException {
        int done = 1;
        int shift = 0;
        while (done < length) {
            take(scanline, 4 * done, 4);
            if (isOldRun(scanline, 4 * done)) {
                if (shift > LARGEST_SHIFT) {
                    throw new IOException("a run length of more than four bytes");
                }
                // Zero is a digit like any other: a run of 256 is 0 and then 1.
                long count = (long) Byte.toUnsignedInt(scanline[4 * done + 3]) << shift;
                checkFits(count, done);
                for (int i = 0; i < count; i++) {
                    System.arraycopy(scanline, 4 * (done - 1), scanline, 4 * (done + i), 4);
                }
                done += (int) count;
                shift += 8;
            } else {
                done++;
                shift = 0;
            }
        }
    }

    private static boolean isOldRun(byte[] scanline, int at) {
        return scanline[at] == 1 && scanline[at + 1] == 1 && scanline[at + 2] == 1;
    }

    private void checkFits(long count, int done) throws IOException {
        if (count > length - done) {
            throw new IOException("a run of " + count + " texels where " + (length - done)
                    + " are left in its scanline of " + length);
        }
    }

    private void take(byte[] target, int at, int count) throws IOException {
        if (content.remaining() < count) {
            throw endOfFile();
        }
        content.next(target, at, count);
    }

    private int takeByte() throws IOException {
        if (content.remaining() < 1) {
            throw endOfFile();
        }
        return content.next();
    }

    private static IOException endOfFile() {
        return new IOException("the file ends before its last texel");
    }
}
