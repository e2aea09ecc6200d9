package dev.twister.image;

import dev.twister.files.WholeFile;
import dev.twister.image.ExrPicture.ExrChannel;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.zip.Deflater;

/** Writes floats as an OpenEXR file ({@code .exr}) of one part: scanlines from the top, ZIP compression. */
public final class ExrWriter {
    static final int CHUNK_HEADER = 2 * Integer.BYTES;

    private ExrWriter() {}

    /**
     * Writes the channels without loss; on failure the file is unchanged. The compressed data is held in memory.
     *
     * @param width pixels in a row, 1 or more
     * @param height rows, 1 or more
     * @param channels 1 or more, with different names, in any order
     * @throws IllegalArgumentException if a channel has another number of values
     * @throws IOException as {@link WholeFile#write}
     */
    public static void write(Path file, int width, int height, List<ExrChannel> channels) throws IOException {
        write(file, new ExrPicture(width, height, 0, height, channels, Optional.empty()));
    }

    /**
     * Writes a picture or a part of one, with its provenance if present.
     *
     * @throws IllegalArgumentException if a channel has another number of values
     * @throws IOException as {@link WholeFile#write}
     */
    public static void write(Path file, ExrPicture picture) throws IOException {
        int width = picture.width();
        int rows = picture.rows();
        for (ExrChannel channel : picture.channels()) {
            long last = channel.first() + (long) channel.stride() * ((long) width * rows - 1);
            if (last >= channel.values().length) {
                throw new IllegalArgumentException("channel " + channel.name() + " of " + width + " x " + rows
                        + " pixels has " + channel.values().length + " floats");
            }
        }
        List<ExrChannel> sorted = picture.channels().stream()
                .sorted(Comparator.comparing(ExrChannel::name))
                .toList();
        byte[] header = ExrHeader.bytes(picture, sorted);
        int count = Math.ceilDiv(rows, ExrChunk.ROWS);
        List<byte[]> chunks = IntStream.range(0, count)
                .parallel()
                .mapToObj(chunk -> ExrChunk.bytes(width, rows, chunk * ExrChunk.ROWS, sorted))
                .toList();
        WholeFile.write(file, out -> {
            out.write(header);
            writeOffsets(out, header.length, chunks);
            for (int chunk = 0; chunk < count; chunk++) {
                byte[] data = chunks.get(chunk);
                out.write(buffer(CHUNK_HEADER)
                        .putInt(picture.firstRow() + chunk * ExrChunk.ROWS)
                        .putInt(data.length)
                        .array());
                out.write(data);
            }
        });
    }

    /** Offsets of the chunks in the file. */
    private static void writeOffsets(OutputStream out, int headerLength, List<byte[]> chunks) throws IOException {
        long offset = headerLength + (long) Long.BYTES * chunks.size();
        for (byte[] data : chunks) {
            out.write(buffer(Long.BYTES).putLong(offset).array());
            offset += CHUNK_HEADER + data.length;
        }
    }

    static ByteBuffer buffer(int bytes) {
        return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Compresses chunks of rows in OpenEXR's ZIP format. */
    private static final class ExrChunk {
        /** Rows per chunk; the last one may have fewer. */
        static final int ROWS = 16;

        private ExrChunk() {}

        /**
         * A chunk from this row on; each row has its channels one after the other. Stored uncompressed if compression
         * does not make it smaller.
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
}
