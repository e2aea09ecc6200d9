package dev.twister.image;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.zip.Deflater;

/** Compresses chunks of rows in OpenEXR's ZIP format. */
final class ExrChunk {
    /** Rows per chunk; the last one may have fewer. */
    static final int ROWS = 16;

    private ExrChunk() {}

    /**
     * A chunk from this row on; each row has its channels one after the other. Stored uncompressed if compression does
     * not make it smaller.
     */
    static byte[] bytes(int width, int height, int firstRow, List<ExrChannel> channels) {
        int rows = Math.min(ROWS, height - firstRow);
        byte[] plain = new byte[Math.multiplyExact(Math.multiplyExact(rows, width), Float.BYTES * channels.size())];
        ByteBuffer buffer = ByteBuffer.wrap(plain).order(ByteOrder.LITTLE_ENDIAN);
        for (int row = firstRow; row < firstRow + rows; row++) {
            for (ExrChannel channel : channels) {
                int at = channel.first() + channel.stride() * row * width;
                for (int column = 0; column < width; column++) {
                    buffer.putFloat(channel.values()[at + channel.stride() * column]);
                }
            }
        }
        byte[] deflated = deflated(differences(halves(plain)));
        return deflated.length < plain.length ? deflated : plain;
    }

    /** The bytes at even indices, then those at odd ones. */
    private static byte[] halves(byte[] bytes) {
        byte[] halves = new byte[bytes.length];
        int half = bytes.length / 2;
        for (int i = 0; i < half; i++) {
            halves[i] = bytes[2 * i];
            halves[half + i] = bytes[2 * i + 1];
        }
        return halves;
    }

    /** Each byte except the first minus the previous one, plus 128. */
    private static byte[] differences(byte[] bytes) {
        byte[] differences = new byte[bytes.length];
        differences[0] = bytes[0];
        for (int i = 1; i < bytes.length; i++) {
            differences[i] = (byte) (bytes[i] - bytes[i - 1] + 128);
        }
        return differences;
    }

    /** Truncated to the input's length if it would be longer. */
    private static byte[] deflated(byte[] bytes) {
        try (Deflater deflater = new Deflater()) {
            deflater.setInput(bytes);
            deflater.finish();
            byte[] deflated = new byte[bytes.length];
            return Arrays.copyOf(deflated, deflater.deflate(deflated));
        }
    }
}
