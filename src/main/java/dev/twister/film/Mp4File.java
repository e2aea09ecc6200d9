package dev.twister.film;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** Checks by the boxes of an MP4 file that it holds a whole film. */
final class Mp4File {
    private static final int HEADER_BYTES = 8;
    private static final int LONG_HEADER_BYTES = 16;
    private static final int MOST_INDEX_BYTES = 1 << 30;

    private Mp4File() {}

    /**
     * A box.
     *
     * @param start of its content in the file, in bytes
     * @param bytes of its content
     */
    private record Box(long start, long bytes) {}

    /**
     * Checks that the boxes fill the file, that there is an index, and that it has the frames and the duration of the
     * format, and places within the data.
     *
     * @throws IOException what is wrong, as the rest of a sentence that begins with the file
     */
    static void check(FileChannel file, FilmFormat format) throws IOException {
        Map<String, Box> boxes = boxes(file);
        Box index = box(boxes, "moov", "it has no index");
        Box data = box(boxes, "mdat", "it has no pictures");
        if (index.bytes() > MOST_INDEX_BYTES) {
            throw new IOException("its index is too large");
        }
        ByteBuffer content = ByteBuffer.allocate((int) index.bytes());
        read(file, content, index.start());
        try {
            check(content.flip(), data, format);
        } catch (RuntimeException damage) {
            throw new IOException("its index is damaged", damage);
        }
    }

    private static Map<String, Box> boxes(FileChannel file) throws IOException {
        Map<String, Box> boxes = new TreeMap<>();
        long place = 0;
        while (place < file.size()) {
            ByteBuffer header = ByteBuffer.allocate(LONG_HEADER_BYTES);
            read(file, header.limit(HEADER_BYTES), place);
            long bytes = Integer.toUnsignedLong(header.getInt(0));
            String type = type(header, Integer.BYTES);
            int headerBytes = HEADER_BYTES;
            if (bytes == 1) {
                headerBytes = LONG_HEADER_BYTES;
                read(file, header.limit(LONG_HEADER_BYTES), place + HEADER_BYTES);
                bytes = header.getLong(HEADER_BYTES);
            }
            if (bytes < headerBytes || bytes > file.size() - place) {
                throw new IOException("it ends within its part '" + type + "'");
            }
            boxes.put(type, new Box(place + headerBytes, bytes - headerBytes));
            place += bytes;
        }
        return boxes;
    }

    private static Box box(Map<String, Box> boxes, String type, String complaint) throws IOException {
        return Optional.ofNullable(boxes.get(type)).orElseThrow(() -> new IOException(complaint));
    }

    /** Fills the buffer up to its limit. */
    private static void read(FileChannel file, ByteBuffer buffer, long place) throws IOException {
        int from = buffer.position();
        while (buffer.hasRemaining()) {
            if (file.read(buffer, place + buffer.position() - from) < 0) {
                throw new EOFException("it ends too early");
            }
        }
    }

    private static void check(ByteBuffer moov, Box data, FilmFormat format) throws IOException {
        ByteBuffer media = inner(moov, "trak", "mdia");
        ByteBuffer samples = inner(media, "minf", "stbl");
        ByteBuffer sizes = inner(samples, "stsz");
        int frames = sizes.getInt(8);
        if (frames != format.frames()) {
            throw new IOException("it has " + frames + " of " + format.frames() + " frames");
        }
        ByteBuffer header = inner(media, "mdhd");
        boolean isLong = header.get(0) == 1;
        double seconds = isLong
                ? (double) header.getLong(24) / header.getInt(20)
                : (double) Integer.toUnsignedLong(header.getInt(16)) / header.getInt(12);
        if (!(Math.abs(seconds - format.frames() / format.rate()) <= 1 / format.rate())) {
            throw new IOException("it is " + seconds + " s long instead of " + format.frames() / format.rate() + " s");
        }
        if (bytes(sizes, frames) > data.bytes()) {
            throw new IOException("its pictures are not whole");
        }
    }

    private static long bytes(ByteBuffer sizes, int frames) {
        long each = Integer.toUnsignedLong(sizes.getInt(4));
        if (each != 0) {
            return frames * each;
        }
        long sum = 0;
        for (int frame = 0; frame < frames; frame++) {
            sum += Integer.toUnsignedLong(sizes.getInt(12 + Integer.BYTES * frame));
        }
        return sum;
    }

    /** The content of the first box of a type, of the first of the next type in it, and so on. */
    private static ByteBuffer inner(ByteBuffer outer, String... types) {
        ByteBuffer content = outer;
        for (String type : types) {
            content = first(content, type);
        }
        return content;
    }

    private static ByteBuffer first(ByteBuffer outer, String type) {
        ByteBuffer rest = outer.duplicate();
        while (true) {
            int start = rest.position();
            int bytes = rest.getInt();
            String found = type(rest, rest.position());
            if (found.equals(type)) {
                return rest.slice(start + HEADER_BYTES, bytes - HEADER_BYTES);
            }
            rest.position(start + Math.max(HEADER_BYTES, bytes));
        }
    }

    private static String type(ByteBuffer buffer, int place) {
        byte[] name = new byte[Integer.BYTES];
        buffer.get(place, name);
        return new String(name, StandardCharsets.ISO_8859_1);
    }
}
