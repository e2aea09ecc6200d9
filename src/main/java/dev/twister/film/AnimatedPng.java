package dev.twister.film;

import dev.twister.files.FileReplacement;
import dev.twister.files.WholeFile;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/** An animated PNG, which browsers play: frames of 24 bits, or 32 with alpha, without loss. */
final class AnimatedPng implements FilmEncoder {
    private static final long SIGNATURE = 0x89504e470d0a1a0aL;
    private static final int COLORS = 3;
    private static final byte BITS = 8;
    private static final byte TRUE_COLOR = 2;
    private static final byte TRUE_COLOR_AND_ALPHA = 6;
    private static final byte PERCEPTUAL = 0;

    /** PNG filter: each byte minus the byte above. */
    private static final int FILTER_UP = 2;

    private static final int FRAME_CONTROL_BYTES = 26;

    /** Largest denominator of a frame's duration. */
    private static final double MOST_PARTS = 65_535;

    private final Path file;
    private final FilmFormat format;
    private final FileReplacement replacement;
    private int frames;
    private int sequence;

    private AnimatedPng(Path file, FilmFormat format, FileReplacement replacement) {
        this.file = file;
        this.format = format;
        this.replacement = replacement;
    }

    /**
     * Begins a film that repeats without end.
     *
     * @throws IOException if the file cannot be written
     */
    static FilmEncoder begin(Path file, FilmFormat format) throws IOException {
        try {
            AnimatedPng film = new AnimatedPng(file, format, FileReplacement.of(file));
            film.writeHeader();
            return film;
        } catch (IOException failure) {
            throw WholeFile.explained(file, failure);
        }
    }

    private void writeHeader() throws IOException {
        replacement
                .out()
                .write(ByteBuffer.allocate(Long.BYTES).putLong(SIGNATURE).array());
        ByteBuffer header = ByteBuffer.allocate(13).putInt(format.width()).putInt(format.height());
        chunk(
                "IHDR",
                header.put(BITS)
                        .put(format.alpha() ? TRUE_COLOR_AND_ALPHA : TRUE_COLOR)
                        .array());
        chunk("sRGB", new byte[] {PERCEPTUAL});
        chunk("acTL", ByteBuffer.allocate(8).putInt(format.frames()).array());
    }

    @Override
    public void add(int[] argb) throws IOException {
        byte[] data = compressed(format, argb);
        try {
            chunk("fcTL", control(sequence++, format));
            if (frames == 0) {
                chunk("IDAT", data);
            } else {
                ByteBuffer numbered = ByteBuffer.allocate(Integer.BYTES + data.length);
                chunk("fdAT", numbered.putInt(sequence++).put(data).array());
            }
            frames++;
        } catch (IOException failure) {
            throw WholeFile.explained(file, failure);
        }
    }

    @Override
    public void finish() throws IOException {
        if (frames != format.frames()) {
            throw new IOException("cannot write " + file + ": it has " + frames + " of " + format.frames() + " frames");
        }
        try {
            chunk("IEND", new byte[0]);
            replacement.finish();
        } catch (IOException failure) {
            throw WholeFile.explained(file, failure);
        }
    }

    @Override
    public void close() throws IOException {
        replacement.close();
    }

    private static byte[] control(int sequence, FilmFormat format) {
        // 1 / rate as a fraction of two 16-bit numbers.
        int seconds = format.rate() == Math.rint(format.rate()) ? 1 : 1000;
        while (seconds > 1 && Math.round(seconds * format.rate()) > MOST_PARTS) {
            seconds /= 10;
        }
        return ByteBuffer.allocate(FRAME_CONTROL_BYTES)
                .putInt(sequence)
                .putInt(format.width())
                .putInt(format.height())
                .putLong(0)
                .putShort((short) seconds)
                .putShort((short) Math.max(1, Math.round(seconds * format.rate())))
                .array();
    }

    private static byte[] compressed(FilmFormat format, int[] pixels) throws IOException {
        ByteArrayOutputStream data = new ByteArrayOutputStream(format.width() * format.height());
        Deflater deflater = new Deflater();
        try (DeflaterOutputStream out = new DeflaterOutputStream(data, deflater, 1 << 16)) {
            int channels = format.alpha() ? COLORS + 1 : COLORS;
            int rowBytes = channels * format.width();
            byte[] above = new byte[rowBytes];
            byte[] row = new byte[rowBytes];
            byte[] filtered = new byte[1 + rowBytes];
            filtered[0] = FILTER_UP;
            for (int y = 0; y < format.height(); y++) {
                for (int x = 0; x < format.width(); x++) {
                    int pixel = pixels[y * format.width() + x];
                    row[channels * x] = (byte) (pixel >> 16);
                    row[channels * x + 1] = (byte) (pixel >> 8);
                    row[channels * x + 2] = (byte) pixel;
                    if (format.alpha()) {
                        row[channels * x + COLORS] = (byte) (pixel >>> 24);
                    }
                }
                for (int i = 0; i < rowBytes; i++) {
                    filtered[1 + i] = (byte) (row[i] - above[i]);
                }
                out.write(filtered);
                byte[] next = above;
                above = row;
                row = next;
            }
        } finally {
            deflater.end();
        }
        return data.toByteArray();
    }

    private void chunk(String type, byte[] data) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 checksum = new CRC32();
        checksum.update(name);
        checksum.update(data);
        DataOutputStream chunk = new DataOutputStream(replacement.out());
        chunk.writeInt(data.length);
        chunk.write(name);
        chunk.write(data);
        chunk.writeInt((int) checksum.getValue());
    }
}
