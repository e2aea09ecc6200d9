package dev.twister.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.DataFormatException;

/** Decompresses PIZ: a table of the values that occur, wavelets and a Huffman code. */
final class PizDecoder {
    private static final int VALUES = 1 << 16;
    private static final int BITMAP_BYTES = VALUES / Byte.SIZE;

    /** Wavelets of smaller values have no modulo. */
    private static final int SMALL = 1 << 14;

    private PizDecoder() {}

    static byte[] decode(byte[] packed, ExrPart part, int width, int height) throws DataFormatException {
        ByteBuffer in = ByteBuffer.wrap(packed).order(ByteOrder.LITTLE_ENDIAN);
        short[] table = new short[VALUES];
        int largest = table(in, table);
        int length = in.getInt();
        ExrChunkDecoder.check(length >= 0 && length <= in.remaining());
        short[] values = new short[width * height * part.pixelBytes() / Short.BYTES];
        PizHuffman.decode(in.slice(in.position(), length).order(ByteOrder.LITTLE_ENDIAN), values);
        int plane = 0;
        for (ExrPart.Channel channel : part.channels()) {
            int shorts = channel.format().bytes() / Short.BYTES;
            for (int i = 0; i < shorts; i++) {
                new Wavelet(values, plane + i, shorts, shorts * width, largest < SMALL).decode(width, height);
            }
            plane += shorts * width * height;
        }
        ByteBuffer planes = ByteBuffer.allocate(values.length * Short.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        for (short value : values) {
            planes.putShort(table[value & 0xffff]);
        }
        return ExrChunkDecoder.byRows(planes.array(), part, width, height);
    }

    /** Reads which values occur; returns the number of the last. */
    private static int table(ByteBuffer in, short[] table) throws DataFormatException {
        int first = in.getShort() & 0xffff;
        int last = in.getShort() & 0xffff;
        ExrChunkDecoder.check(last < BITMAP_BYTES);
        byte[] bitmap = new byte[BITMAP_BYTES];
        if (first <= last) {
            in.get(bitmap, first, last - first + 1);
        }
        // 0 is always there.
        bitmap[0] |= 1;
        int count = 0;
        for (int value = 0; value < VALUES; value++) {
            if ((bitmap[value / Byte.SIZE] >> value % Byte.SIZE & 1) == 1) {
                table[count++] = (short) value;
            }
        }
        return count - 1;
    }

    /**
     * Wavelets of a plane.
     *
     * @param first index of its first value
     * @param right distance between neighbors in a row
     * @param down distance between neighbors in a column
     */
    @SuppressWarnings("ArrayRecordComponent") // changed in place
    private record Wavelet(short[] values, int first, int right, int down, boolean small) {
        void decode(int width, int height) {
            for (int step = Integer.highestOneBit(Math.min(width, height)) / 2; step >= 1; step /= 2) {
                level(width, height, step);
            }
        }

        private void level(int width, int height, int step) {
            int y = 0;
            for (; y + 2 * step <= height; y += 2 * step) {
                int x = 0;
                for (; x + 2 * step <= width; x += 2 * step) {
                    int at = first + y * down + x * right;
                    int beside = at + step * right;
                    pair(at, at + step * down);
                    pair(beside, beside + step * down);
                    pair(at, beside);
                    pair(at + step * down, beside + step * down);
                }
                if ((width & step) != 0) {
                    int at = first + y * down + x * right;
                    pair(at, at + step * down);
                }
            }
            if ((height & step) != 0) {
                for (int x = 0; x + 2 * step <= width; x += 2 * step) {
                    int at = first + y * down + x * right;
                    pair(at, at + step * right);
                }
            }
        }

        /** From a mean and a difference to two values. */
        private void pair(int low, int high) {
            int mean = values[low];
            int difference = values[high];
            if (small) {
                int a = mean + (difference & 1) + (difference >> 1);
                values[low] = (short) a;
                values[high] = (short) (a - difference);
            } else {
                int b = (mean & 0xffff) - ((difference & 0xffff) >> 1);
                values[high] = (short) b;
                values[low] = (short) ((difference & 0xffff) + b - (1 << 15));
            }
        }
    }
}
