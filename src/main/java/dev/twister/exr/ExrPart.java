package dev.twister.exr;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.DataFormatException;

/**
 * What a part of a file says before its pixels.
 *
 * @param display the picture
 * @param data where pixels are stored, which may be less than the picture or more
 * @param tile the size of tiles, at its left top corner 0; of none if the part has rows
 * @param attributes the bytes of each by name
 */
record ExrPart(
        Box display,
        Box data,
        List<Channel> channels,
        ExrCompression compression,
        Optional<Box> tile,
        Map<String, byte[]> attributes) {
    /** A rectangle of pixels. */
    record Box(int left, int top, int width, int height) {
        long area() {
            return (long) width * height;
        }

        int right() {
            return left + width;
        }

        int bottom() {
            return top + height;
        }
    }

    /**
     * A channel.
     *
     * @param perceptual whether B44 stores its logarithm
     */
    record Channel(String name, ExrFormat format, boolean perceptual) {}

    private static final int LARGEST_COORDINATE = 1 << 24;

    /**
     * Reads attributes.
     *
     * @param tiled whether the file says that its only part has tiles
     * @throws DataFormatException if they are damaged
     * @throws IOException if they ask for what is not read
     */
    static ExrPart of(Map<String, byte[]> attributes, boolean tiled) throws IOException, DataFormatException {
        String type = text(attributes, "type").orElse(tiled ? "tiledimage" : "scanlineimage");
        if (type.startsWith("deep")) {
            throw new IOException("holds deep pixels, which are not read");
        }
        ExrCompression compression =
                compression(attribute(attributes, "compression").get());
        Optional<Box> tile = Optional.empty();
        if (type.equals("tiledimage")) {
            ByteBuffer tiles = attribute(attributes, "tiles");
            tile = Optional.of(new Box(0, 0, tiles.getInt(), tiles.getInt()));
            check(tile.get().width() > 0 && tile.get().height() > 0);
        }
        return new ExrPart(
                box(attributes, "displayWindow"),
                box(attributes, "dataWindow"),
                channels(attribute(attributes, "channels")),
                compression,
                tile,
                attributes);
    }

    private static ExrCompression compression(int number) throws IOException {
        ExrCompression[] all = ExrCompression.values();
        if (number < 0 || number >= all.length || !all[number].isRead()) {
            throw new IOException("has " + (number >= 0 && number < all.length ? all[number] : "the unknown")
                    + " compression, which is not read; 'oiiotool FILE --compression zip -o OUTPUT' converts it");
        }
        return all[number];
    }

    private static Box box(Map<String, byte[]> attributes, String name) throws DataFormatException {
        ByteBuffer numbers = attribute(attributes, name);
        int left = numbers.getInt();
        int top = numbers.getInt();
        int right = numbers.getInt();
        int bottom = numbers.getInt();
        check(left >= -LARGEST_COORDINATE && top >= -LARGEST_COORDINATE && right >= left && bottom >= top);
        // A height may be any, as rows are counted by the file's length.
        check(right < LARGEST_COORDINATE && (long) bottom - top < Integer.MAX_VALUE);
        return new Box(left, top, right - left + 1, bottom - top + 1);
    }

    private static List<Channel> channels(ByteBuffer list) throws IOException, DataFormatException {
        List<Channel> channels = new ArrayList<>();
        ExrFormat[] formats = ExrFormat.values();
        for (String name = text(list); !name.isEmpty(); name = text(list)) {
            int format = list.getInt();
            check(format >= 0 && format < formats.length);
            boolean perceptual = list.get() != 0;
            list.position(list.position() + 3);
            int across = list.getInt();
            int down = list.getInt();
            if (across != 1 || down != 1) {
                throw new IOException("has fewer values than pixels in channel " + name + ", which is not read");
            }
            channels.add(new Channel(name, formats[format], perceptual));
        }
        check(!channels.isEmpty());
        return channels;
    }

    private static String text(ByteBuffer bytes) {
        StringBuilder text = new StringBuilder();
        for (byte next = bytes.get(); next != 0; next = bytes.get()) {
            text.append((char) (next & 0xff));
        }
        return text.toString();
    }

    private static ByteBuffer attribute(Map<String, byte[]> attributes, String name) throws DataFormatException {
        check(attributes.containsKey(name));
        return ByteBuffer.wrap(attributes.get(name)).order(ByteOrder.LITTLE_ENDIAN);
    }

    static Optional<String> text(Map<String, byte[]> attributes, String name) {
        return Optional.ofNullable(attributes.get(name)).map(value -> new String(value, StandardCharsets.UTF_8));
    }

    private static void check(boolean right) throws DataFormatException {
        if (!right) {
            throw new DataFormatException();
        }
    }

    /** Bytes of a pixel. */
    int pixelBytes() {
        return channels.stream().mapToInt(channel -> channel.format().bytes()).sum();
    }

    /** Chunks of the pixels, without smaller copies of a tiled picture. */
    long chunks() {
        return tile.map(box ->
                        (long) Math.ceilDiv(data.width(), box.width()) * Math.ceilDiv(data.height(), box.height()))
                .orElse((long) Math.ceilDiv(data.height(), compression.rows()));
    }

    /** How chunks are compressed, in the order of the format's numbers, and how many rows a chunk has. */
    enum ExrCompression {
        NONE(1, true),
        RLE(1, true),
        ZIPS(1, true),
        ZIP(16, true),
        PIZ(32, true),
        PXR24(16, true),
        B44(32, true),
        B44A(32, true),
        DWAA(32, false),
        DWAB(256, false);

        private final int rows;
        private final boolean read;

        ExrCompression(int rows, boolean read) {
            this.rows = rows;
            this.read = read;
        }

        int rows() {
            return rows;
        }

        /** Whether there is a decoder for it here. */
        boolean isRead() {
            return read;
        }
    }

    /** A channel's numbers, in the order of the format's numbers. */
    enum ExrFormat {
        UINT(4),
        HALF(2),
        FLOAT(4);

        private final int bytes;

        ExrFormat(int bytes) {
            this.bytes = bytes;
        }

        int bytes() {
            return bytes;
        }
    }
}
