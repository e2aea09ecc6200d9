package dev.twister.image;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.file.Path;

/**
 * The first chunk of a PNG file.
 *
 * @param bits per channel
 * @param channels per pixel
 */
record PngHeader(PictureSize size, int bits, int channels) {
    private static final int BYTES = 13;
    private static final int TYPE = 0x49484452;
    private static final int REST = 3 + Integer.BYTES;

    /** Reads the chunk, which follows the signature. */
    static PngHeader read(Path file, DataInputStream in) throws IOException {
        if (in.readInt() != BYTES || in.readInt() != TYPE) {
            throw new IOException(file + ": a PNG that does not start with its IHDR chunk");
        }
        int width = in.readInt();
        int height = in.readInt();
        if (width < 1 || height < 1 || (long) width * height > Integer.MAX_VALUE) {
            throw new IOException(file + ": a PNG of " + Integer.toUnsignedString(width) + " x "
                    + Integer.toUnsignedString(height) + " pixels");
        }
        int bits = in.readUnsignedByte();
        int channels = switch (in.readUnsignedByte()) {
            case 2 -> 3;
            case 4 -> 2;
            case 6 -> 4;
            default -> 1;
        };
        in.skipNBytes(REST);
        return new PngHeader(new PictureSize(width, height), bits, channels);
    }

    long uncompressedBytes() {
        return size.pixels() * channels * bits / Byte.SIZE;
    }
}
