package dev.twister.sky;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.Deflater;

/** Creates PNG files of one row, chunk by chunk. */
public final class PngBytes {
    public static final int GRAY = 0;
    public static final int RGB = 2;
    public static final int PALETTE = 3;
    public static final int GRAY_ALPHA = 4;
    public static final int RGBA = 6;

    private final ByteArrayOutputStream file = new ByteArrayOutputStream();

    private PngBytes() {}

    /** A file with this number of texels, up to its header. */
    public static PngBytes start(int width, int bits, int colorType) {
        PngBytes png = new PngBytes();
        png.file.writeBytes("\u0089PNG\r\n\u001a\n".getBytes(StandardCharsets.ISO_8859_1));
        byte[] header = ByteBuffer.allocate(13)
                .putInt(width)
                .putInt(1)
                .put((byte) bits)
                .put((byte) colorType)
                .array();
        return png.chunk("IHDR", header);
    }

    public PngBytes chunk(String type, int... bytes) {
        return chunk(type, bytes(bytes));
    }

    public PngBytes chunk(String type, byte[] data) {
        return chunk(type, data, 0);
    }

    /** A chunk with a wrong checksum. */
    public PngBytes damagedChunk(String type, byte[] data) {
        return chunk(type, data, 1);
    }

    /** A gAMA chunk; the parameter is in 100,000ths. */
    public PngBytes gamma(int value) {
        return chunk("gAMA", ByteBuffer.allocate(4).putInt(value).array());
    }

    /** A cHRM chunk: white, red, green and blue, in 100,000ths. */
    public PngBytes chromaticities(int... xy) {
        ByteBuffer data = ByteBuffer.allocate(4 * xy.length);
        for (int value : xy) {
            data.putInt(value);
        }
        return chunk("cHRM", data.array());
    }

    /** An iCCP chunk. */
    public PngBytes profile(byte[] profile) {
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        data.writeBytes(new byte[] {'p', 0, 0});
        data.writeBytes(deflated(profile));
        return chunk("iCCP", data.toByteArray());
    }

    /** The whole file, with the bytes of its row. */
    public byte[] texels(int... row) {
        return texels(bytes(row));
    }

    public byte[] texels(byte[] row) {
        byte[] filtered = new byte[row.length + 1];
        System.arraycopy(row, 0, filtered, 1, row.length);
        chunk("IDAT", deflated(filtered));
        return end();
    }

    public byte[] end() {
        return chunk("IEND").file.toByteArray();
    }

    public static byte[] deflated(byte[] data) {
        try (Deflater deflater = new Deflater()) {
            deflater.setInput(data);
            deflater.finish();
            byte[] buffer = new byte[data.length + 100];
            return Arrays.copyOf(buffer, deflater.deflate(buffer));
        }
    }

    private PngBytes chunk(String type, byte[] data, int error) {
        byte[] name = type.getBytes(StandardCharsets.ISO_8859_1);
        CRC32 sum = new CRC32();
        sum.update(name);
        sum.update(data);
        file.writeBytes(ByteBuffer.allocate(4).putInt(data.length).array());
        file.writeBytes(name);
        file.writeBytes(data);
        file.writeBytes(
                ByteBuffer.allocate(4).putInt((int) sum.getValue() + error).array());
        return this;
    }

    private static byte[] bytes(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        return bytes;
    }
}
