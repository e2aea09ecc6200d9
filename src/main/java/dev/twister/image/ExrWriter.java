package dev.twister.image;

import dev.twister.files.WholeFile;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

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
}
