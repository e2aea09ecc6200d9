package dev.twister.image;

import dev.twister.files.Deflate;
import dev.twister.files.InputFile;
import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.zip.DataFormatException;

/** Reads OpenEXR files as {@link ExrWriter} writes them; others are refused. */
public final class ExrReader {
    private static final int CHANNEL_NUMBERS = 4 * Integer.BYTES;
    private static final int MOST_ATTRIBUTE_BYTES = 1 << 20;
    private static final long MOST_PIXELS = 1 << 28;

    private ExrReader() {}

    /**
     * Reads a complete file.
     *
     * @throws IOException if it cannot be read, is incomplete, or is not Twister's; the message is one line and names
     *     the file
     */
    public static ExrPicture read(Path file) throws IOException {
        return read(file, ExrReader::picture);
    }

    /**
     * Reads which rows of a picture a file has.
     *
     * @throws IOException as {@link #read(Path)}
     */
    public static ExrExtent extent(Path file) throws IOException {
        return read(file, (_, header) -> header.extent());
    }

    private interface Content<T> {
        T read(DataInputStream in, Header header) throws IOException, DataFormatException;
    }

    /** What precedes the pixels, checked against the file's length. */
    private record Header(ExrExtent extent, List<String> channels, Optional<Provenance> provenance) {}

    private static <T> T read(Path file, Content<T> content) throws IOException {
        try (InputStream bytes = InputFile.open(file);
                DataInputStream in = new DataInputStream(new BufferedInputStream(bytes, 1 << 16))) {
            return content.read(in, header(in, Files.size(file)));
        } catch (EOFException problem) {
            throw new IOException(file + " is not whole: it ends before its last row", problem);
        } catch (DataFormatException | RuntimeException problem) {
            throw new IOException(file + " is no .exr file of Twister's, or is damaged", problem);
        }
    }

    private static Header header(DataInputStream in, long fileBytes) throws IOException, DataFormatException {
        ByteBuffer magic = numbers(in.readNBytes(2 * Integer.BYTES));
        check(magic.getInt() == ExrHeader.MAGIC && magic.getInt() == ExrHeader.VERSION);
        Map<String, ByteBuffer> attributes = attributes(in);
        check(attributes.get("compression").get() == ExrHeader.ZIP);
        ByteBuffer display = attributes.get("displayWindow");
        ByteBuffer data = attributes.get("dataWindow");
        int width = display.getInt(2 * Integer.BYTES) + 1;
        int height = display.getInt(3 * Integer.BYTES) + 1;
        int firstRow = data.getInt(Integer.BYTES);
        int rows = data.getInt(3 * Integer.BYTES) - firstRow + 1;
        check(width > 0 && rows > 0 && firstRow >= 0 && rows <= height - firstRow);
        check((long) width * rows <= MOST_PIXELS && data.getInt(2 * Integer.BYTES) == width - 1);
        List<String> channels = channels(attributes.get("channels"));
        check(Deflate.canHold(fileBytes, (long) width * rows * Float.BYTES * channels.size()));
        return new Header(new ExrExtent(width, height, firstRow, rows), channels, provenance(attributes));
    }

    private static ExrPicture picture(DataInputStream in, Header header) throws IOException, DataFormatException {
        int width = header.extent().width();
        int rows = header.extent().rows();
        List<ExrChannel> channels = header.channels().stream()
                .map(name -> new ExrChannel(name, new float[width * rows], 0, 1))
                .toList();
        int chunks = Math.ceilDiv(rows, ExrChunk.ROWS);
        in.skipNBytes((long) Long.BYTES * chunks);
        for (int chunk = 0; chunk < chunks; chunk++) {
            byte[] start = new byte[ExrWriter.CHUNK_HEADER];
            in.readFully(start);
            int length = numbers(start).getInt(Integer.BYTES);
            int most = Math.min(ExrChunk.ROWS, rows - chunk * ExrChunk.ROWS);
            check(length >= 0 && length <= (long) most * width * Float.BYTES * channels.size());
            byte[] packed = new byte[length];
            in.readFully(packed);
            ExrChunk.read(packed, width, rows, chunk * ExrChunk.ROWS, channels);
        }
        return new ExrPicture(
                width, header.extent().height(), header.extent().firstRow(), rows, channels, header.provenance());
    }

    private static Optional<Provenance> provenance(Map<String, ByteBuffer> attributes) {
        return text(attributes, Provenance.NAME)
                .flatMap(text ->
                        Provenance.of(text(attributes, Provenance.SOFTWARE).orElse(""), text));
    }

    private static Optional<String> text(Map<String, ByteBuffer> attributes, String name) {
        return Optional.ofNullable(attributes.get(name.toLowerCase(Locale.ROOT)))
                .map(value -> StandardCharsets.US_ASCII.decode(value).toString());
    }

    private static Map<String, ByteBuffer> attributes(DataInputStream in) throws IOException, DataFormatException {
        Map<String, ByteBuffer> attributes = new HashMap<>();
        String name = text(in);
        while (!name.isEmpty()) {
            text(in);
            int length = numbers(in.readNBytes(Integer.BYTES)).getInt();
            check(length >= 0 && length <= MOST_ATTRIBUTE_BYTES);
            byte[] value = new byte[length];
            in.readFully(value);
            attributes.put(name, numbers(value));
            name = text(in);
        }
        return attributes;
    }

    private static List<String> channels(ByteBuffer list) throws DataFormatException {
        List<String> channels = new ArrayList<>();
        int first = list.get();
        while (first != 0) {
            StringBuilder name = new StringBuilder();
            for (int next = first; next != 0; next = list.get()) {
                name.append((char) next);
            }
            check(list.getInt() == ExrHeader.FLOAT);
            list.position(list.position() + CHANNEL_NUMBERS - Integer.BYTES);
            channels.add(name.toString());
            first = list.get();
        }
        return channels;
    }

    private static String text(DataInputStream in) throws IOException {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        for (int next = in.readUnsignedByte(); next != 0; next = in.readUnsignedByte()) {
            text.write(next);
        }
        return text.toString(StandardCharsets.US_ASCII);
    }

    private static ByteBuffer numbers(byte[] bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static void check(boolean right) throws DataFormatException {
        if (!right) {
            throw new DataFormatException();
        }
    }
}
