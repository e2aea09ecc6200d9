package dev.twister.exr;

import dev.twister.exr.ExrPart.ExrFormat;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Decompresses chunks into rows, each with its channels one after the other. */
final class ExrChunkDecoder {
    private ExrChunkDecoder() {}

    /**
     * Decompresses a chunk.
     *
     * @param packed at most as long as the rows; equally long if it is not compressed
     */
    static byte[] decode(byte[] packed, ExrPart part, int width, int height) throws DataFormatException {
        int length = width * height * part.pixelBytes();
        if (packed.length == length) {
            return packed;
        }
        return switch (part.compression()) {
            case NONE, DWAA, DWAB -> throw new DataFormatException();
            case RLE -> unpredicted(runs(packed, length));
            case ZIPS, ZIP -> unpredicted(inflated(packed, length));
            case PIZ -> PizDecoder.decode(packed, part, width, height);
            case PXR24 -> pixar(packed, part, width, height);
            case B44, B44A -> B44Decoder.decode(packed, part, width, height);
        };
    }

    private static byte[] runs(byte[] packed, int length) throws DataFormatException {
        byte[] plain = new byte[length];
        int at = 0;
        int from = 0;
        while (from < packed.length) {
            int count = packed[from++];
            if (count < 0) {
                System.arraycopy(packed, from, plain, at, -count);
                from -= count;
                at -= count;
            } else {
                Arrays.fill(plain, at, at + count + 1, packed[from++]);
                at += count + 1;
            }
        }
        check(at == length);
        return plain;
    }

    /** Inflates data that must have this length. */
    static byte[] inflated(byte[] packed, int length) throws DataFormatException {
        byte[] plain = new byte[length];
        try (Inflater inflater = new Inflater()) {
            inflater.setInput(packed);
            check(inflater.inflate(plain) == length);
            // The checksum at the end is read with the next byte.
            check(inflater.inflate(new byte[1]) == 0 && inflater.finished());
        }
        return plain;
    }

    /** Undoes differences of bytes, and that even bytes came before odd ones. */
    private static byte[] unpredicted(byte[] bytes) {
        for (int i = 1; i < bytes.length; i++) {
            bytes[i] = (byte) (bytes[i] + bytes[i - 1] - 128);
        }
        byte[] whole = new byte[bytes.length];
        int half = (bytes.length + 1) / 2;
        for (int i = 0; i < bytes.length; i++) {
            whole[i] = bytes[i / 2 + (i % 2 == 0 ? 0 : half)];
        }
        return whole;
    }

    /** PXR24: differences of numbers, byte by byte, floats without their lowest one. */
    private static byte[] pixar(byte[] packed, ExrPart part, int width, int height) throws DataFormatException {
        int stored = part.channels().stream()
                .mapToInt(channel -> storedBytes(channel.format()))
                .sum();
        byte[] planes = inflated(packed, stored * width * height);
        ByteBuffer plain =
                ByteBuffer.allocate(part.pixelBytes() * width * height).order(ByteOrder.LITTLE_ENDIAN);
        int from = 0;
        for (int y = 0; y < height; y++) {
            for (ExrPart.Channel channel : part.channels()) {
                int bytes = storedBytes(channel.format());
                int value = 0;
                for (int x = 0; x < width; x++) {
                    int difference = 0;
                    for (int plane = 0; plane < bytes; plane++) {
                        difference = difference << Byte.SIZE | (planes[from + plane * width + x] & 0xff);
                    }
                    value += difference;
                    switch (channel.format()) {
                        case HALF -> plain.putShort((short) value);
                        case FLOAT -> plain.putInt(value << Byte.SIZE);
                        case UINT -> plain.putInt(value);
                    }
                }
                from += bytes * width;
            }
        }
        return plain.array();
    }

    private static int storedBytes(ExrFormat format) {
        return format == ExrFormat.FLOAT ? 3 : format.bytes();
    }

    /** Puts the channels' planes together, row by row. */
    static byte[] byRows(byte[] planes, ExrPart part, int width, int height) {
        byte[] rows = new byte[planes.length];
        int to = 0;
        for (int y = 0; y < height; y++) {
            int plane = 0;
            for (ExrPart.Channel channel : part.channels()) {
                int bytes = channel.format().bytes() * width;
                System.arraycopy(planes, plane + y * bytes, rows, to, bytes);
                plane += bytes * height;
                to += bytes;
            }
        }
        return rows;
    }

    /** Ends the reading of a file that is not as its format says. */
    static void check(boolean right) throws DataFormatException {
        if (!right) {
            throw new DataFormatException();
        }
    }
}
