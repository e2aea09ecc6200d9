package dev.twister.sky;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.zip.CRC32;

/**
 * Walks through the chunks of a PNG file before it is decoded. Java's own decoder skips the checksums, believes in any
 * length a chunk claims and makes room for any size the header claims.
 */
final class PngChunks {
    private static final int SIGNATURE_BYTES = 8;
    private static final int FRAME_BYTES = 12;
    private static final int HEADER_BYTES = 13;
    private static final int IHDR = 0x49484452;
    private static final int IDAT = 0x49444154;
    private static final int IEND = 0x49454e44;

    /** The most that deflate can compress: a match of 258 bytes in two bits. */
    private static final int LARGEST_RATIO = 1032;

    private PngChunks() {}

    /** Checks lengths and checksums, the size, and that there is enough data for the size; the position stays. */
    static void check(ByteBuffer content) throws IOException {
        ByteBuffer file = content.duplicate();
        file.position(file.position() + SIGNATURE_BYTES);
        long uncompressed = -1;
        long compressed = 0;
        int type = 0;
        while (type != IEND) {
            if (file.remaining() < FRAME_BYTES) {
                throw new IOException("the PNG ends before its IEND chunk");
            }
            int length = file.getInt();
            if (length < 0 || length > file.remaining() - (FRAME_BYTES - 4)) {
                throw new IOException("a PNG chunk of " + Integer.toUnsignedLong(length) + " bytes where only "
                        + (file.remaining() - (FRAME_BYTES - 4)) + " are left in the file");
            }
            int start = file.position();
            type = file.getInt(start);
            checkSum(file, start, length);
            if (uncompressed < 0) {
                uncompressed = uncompressedBytes(file, start, type, length);
            }
            if (type == IDAT) {
                compressed += length;
            }
            file.position(start + 4 + length + 4);
        }
        if (uncompressed > compressed * LARGEST_RATIO) {
            throw new IOException(
                    "a PNG of " + uncompressed + " bytes cannot come from " + compressed + " compressed ones");
        }
    }

    private static void checkSum(ByteBuffer file, int start, int length) throws IOException {
        CRC32 sum = new CRC32();
        sum.update(file.slice(start, 4 + length));
        if ((int) sum.getValue() != file.getInt(start + 4 + length)) {
            throw new IOException("a damaged PNG: the checksum of a chunk does not match");
        }
    }

    private static long uncompressedBytes(ByteBuffer file, int start, int type, int length) throws IOException {
        if (type != IHDR || length != HEADER_BYTES) {
            throw new IOException("a PNG that does not start with its IHDR chunk");
        }
        int header = start + 4;
        long width = Integer.toUnsignedLong(file.getInt(header));
        long height = Integer.toUnsignedLong(file.getInt(header + 4));
        SkyboxLimits.checkSize(width, height);
        int bits = file.get(header + 8);
        int channels = switch (file.get(header + 9)) {
            case 2 -> 3;
            case 4 -> 2;
            case 6 -> 4;
            default -> 1;
        };
        return width * height * channels * bits / 8;
    }
}
