package dev.twister.exr;

import dev.twister.exr.ExrPart.Box;
import dev.twister.exr.ExrPart.ExrFormat;
import dev.twister.files.Deflate;
import java.io.EOFException;
import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.DataFormatException;

/**
 * An OpenEXR file of any program: rows or tiles in any order, half, float and integer channels, all compressions except
 * DWA; of several parts the first. Memory is bounded by the file's length. Messages of {@link IOException} continue the
 * file's name; a {@link DataFormatException} means damage, an {@link EOFException} that the file is not whole.
 */
public final class OpenExrFile {
    private static final int MAGIC = 20_000_630;
    private static final int VERSION_MASK = 0xff;
    private static final int VERSION = 2;
    private static final int TILED = 0x200;
    private static final int DEEP = 0x800;
    private static final int PARTS = 0x1000;
    private static final int LONGEST_NAME = 255;
    private static final int MOST_ATTRIBUTE_BYTES = 1 << 24;
    private static final long MOST_PIXELS = 1 << 28;

    /** Pixels that a picture may always have, and how many more than stored ones. */
    private static final long FREE_PIXELS = 1 << 24;

    private static final int MOST_EMPTY = 64;

    private final ExrBytes file;
    private final ExrPart part;
    private final boolean hasParts;
    private final int parts;
    private final long offsets;
    private final Box visible;

    /** Reads what precedes the pixels. */
    public OpenExrFile(ExrBytes file) throws IOException, DataFormatException {
        this.file = file;
        ByteBuffer start = file.read(0, 2 * Integer.BYTES);
        check(start.getInt() == MAGIC);
        int version = start.getInt();
        check((version & VERSION_MASK) == VERSION);
        if ((version & DEEP) != 0 && (version & PARTS) == 0) {
            throw new IOException("holds deep pixels, which are not read");
        }
        hasParts = (version & PARTS) != 0;
        Cursor cursor = new Cursor(2 * Integer.BYTES);
        try {
            part = ExrPart.of(cursor.attributes(), (version & TILED) != 0);
        } catch (BufferUnderflowException | IllegalArgumentException tooShort) {
            throw damaged(tooShort);
        }
        int count = 1;
        while (hasParts && !cursor.atEnd()) {
            cursor.attributes();
            count++;
        }
        parts = count;
        offsets = cursor.position + (hasParts ? 1 : 0);
        visible = visible(part.display(), part.data());
        check(visible.height() > 0 && visible.width() > 0 && part.data().area() <= MOST_PIXELS);
        check(Deflate.canHold(file.length(), part.data().area() * part.pixelBytes()));
        checkEmpty(width(), rows());
    }

    /** The stored pixels that belong to the picture. */
    private static Box visible(Box display, Box data) {
        int left = Math.max(display.left(), data.left());
        int top = Math.max(display.top(), data.top());
        int right = Math.min(display.right(), data.right());
        int bottom = (int) Math.min((long) display.top() + display.height(), (long) data.top() + data.height());
        return new Box(left, top, right - left, bottom - top);
    }

    /**
     * Checks that a picture is not far larger than what is stored of it.
     *
     * @throws IOException if it is
     */
    public void checkEmpty(int width, int height) throws IOException {
        long pixels = (long) width * height;
        if (pixels > FREE_PIXELS && pixels / MOST_EMPTY > part.data().area()) {
            throw new IOException("is of " + width + " x " + height + " pixels, but stores only "
                    + part.data().area());
        }
    }

    /** Reads attributes. */
    private final class Cursor {
        private long position;

        Cursor(long position) {
            this.position = position;
        }

        boolean atEnd() throws IOException {
            return file.read(position, 1).get() == 0;
        }

        Map<String, byte[]> attributes() throws IOException, DataFormatException {
            Map<String, byte[]> attributes = new HashMap<>();
            for (String name = text(); !name.isEmpty(); name = text()) {
                text();
                int length = file.read(position, Integer.BYTES).getInt();
                check(length >= 0 && length <= MOST_ATTRIBUTE_BYTES);
                attributes.put(name, file.read(position + Integer.BYTES, length).array());
                position += Integer.BYTES + length;
            }
            return attributes;
        }

        private String text() throws IOException, DataFormatException {
            int most = (int) Math.min(LONGEST_NAME + 1, file.length() - position);
            byte[] bytes = file.read(position, Math.max(1, most)).array();
            int length = 0;
            while (length < bytes.length && bytes[length] != 0) {
                length++;
            }
            if (length == bytes.length && length <= LONGEST_NAME) {
                throw new EOFException();
            }
            check(length < bytes.length);
            position += length + 1;
            return new String(bytes, 0, length, StandardCharsets.ISO_8859_1);
        }
    }

    /** Pixels in a row of the picture. */
    public int width() {
        return part.display().width();
    }

    /** Rows of the picture. */
    public int height() {
        return part.display().height();
    }

    /** The first row that is stored, from the picture's top. */
    public int firstRow() {
        return visible.top() - part.display().top();
    }

    /** Rows that are stored. */
    public int rows() {
        return visible.height();
    }

    /** Names of channels, in the file's order. */
    public List<String> channels() {
        return part.channels().stream().map(ExrPart.Channel::name).toList();
    }

    /** The bytes of an attribute. */
    public Optional<byte[]> attribute(String name) {
        return Optional.ofNullable(part.attributes().get(name)).map(byte[]::clone);
    }

    /** An attribute as text. */
    public Optional<String> text(String name) {
        return ExrPart.text(part.attributes(), name);
    }

    /** Such as {@code the first of 3 parts, 'beauty'}, if the file has several: no other part is read. */
    public Optional<String> firstPart() {
        return Optional.of("the first of " + parts + " parts"
                        + text("name").map(name -> ", '" + name + "'").orElse(""))
                .filter(_ -> parts > 1);
    }

    /**
     * Reads channels.
     *
     * @param names some of {@link #channels}
     * @return for each {@code width() * rows()} values, row by row from the top; 0 where none are stored
     */
    public List<float[]> read(List<String> names) throws IOException, DataFormatException {
        List<float[]> values = names.stream()
                .map(_ -> new float[Math.multiplyExact(width(), rows())])
                .toList();
        long chunks = part.chunks();
        long left = file.length();
        for (long chunk = 0; chunk < chunks; chunk++) {
            long offset = file.read(offsets + Long.BYTES * chunk, Long.BYTES).getLong();
            if (offset == 0) {
                throw new EOFException();
            }
            left -= readChunk(offset, names, values);
            // Otherwise many chunks could be the same bytes.
            check(left >= 0);
        }
        return values;
    }

    /** Reads a chunk; returns its length. */
    private int readChunk(long offset, List<String> names, List<float[]> values)
            throws IOException, DataFormatException {
        int number = hasParts ? Integer.BYTES : 0;
        ByteBuffer header = file.read(offset + number, (part.tile().isPresent() ? 5 : 2) * Integer.BYTES);
        Box box = part.tile().isPresent() ? tile(header) : rows(header);
        int length = header.getInt();
        long plain = box.area() * part.pixelBytes();
        check(length >= 0 && length <= plain && plain <= Integer.MAX_VALUE - 8);
        byte[] packed = file.read(offset + number + header.position(), length).array();
        try {
            byte[] pixels = ExrChunkDecoder.decode(packed, part, box.width(), box.height());
            for (int i = 0; i < names.size(); i++) {
                put(pixels, box, names.get(i), values.get(i));
            }
        } catch (IndexOutOfBoundsException | BufferUnderflowException damage) {
            throw damaged(damage);
        }
        return length;
    }

    private Box rows(ByteBuffer header) throws DataFormatException {
        Box data = part.data();
        int top = header.getInt();
        int rows = part.compression().rows();
        check(top >= data.top() && top < data.bottom() && (top - data.top()) % rows == 0);
        return new Box(data.left(), top, data.width(), Math.min(rows, data.bottom() - top));
    }

    private Box tile(ByteBuffer header) throws DataFormatException {
        Box data = part.data();
        Box tile = part.tile().orElseThrow();
        long left = data.left() + (long) header.getInt() * tile.width();
        long top = data.top() + (long) header.getInt() * tile.height();
        // The first level of detail.
        int across = header.getInt();
        int down = header.getInt();
        check(across == 0 && down == 0);
        check(left >= data.left() && left < data.right() && top >= data.top() && top < data.bottom());
        return new Box((int) left, (int) top, (int) Math.min(tile.width(), data.right() - left), (int)
                Math.min(tile.height(), data.bottom() - top));
    }

    /** Copies a channel of a chunk, which has the channels of each row one after the other. */
    private void put(byte[] pixels, Box box, String name, float[] values) {
        ByteBuffer bytes = ByteBuffer.wrap(pixels).order(ByteOrder.LITTLE_ENDIAN);
        int first = 0;
        int index = 0;
        while (!part.channels().get(index).name().equals(name)) {
            first += part.channels().get(index).format().bytes() * box.width();
            index++;
        }
        ExrFormat format = part.channels().get(index).format();
        int from = Math.max(box.left(), visible.left());
        int to = Math.min(box.right(), visible.right());
        for (int y = Math.max(box.top(), visible.top()); y < Math.min(box.bottom(), visible.bottom()); y++) {
            int row = (y - box.top()) * box.width() * part.pixelBytes() + first;
            int target = (y - visible.top()) * width() - part.display().left();
            for (int x = from; x < to; x++) {
                values[target + x] = value(bytes, row + (x - box.left()) * format.bytes(), format);
            }
        }
    }

    private static float value(ByteBuffer bytes, int at, ExrFormat format) {
        return switch (format) {
            case UINT -> Integer.toUnsignedLong(bytes.getInt(at));
            case HALF -> Float.float16ToFloat(bytes.getShort(at));
            case FLOAT -> bytes.getFloat(at);
        };
    }

    private static DataFormatException damaged(RuntimeException cause) {
        DataFormatException damaged = new DataFormatException();
        damaged.initCause(cause);
        return damaged;
    }

    private static void check(boolean right) throws DataFormatException {
        if (!right) {
            throw new DataFormatException();
        }
    }
}
