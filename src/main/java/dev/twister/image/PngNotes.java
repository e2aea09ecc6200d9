package dev.twister.image;

import dev.twister.files.Deflate;
import dev.twister.files.InputFile;
import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.zip.CRC32;
import java.util.zip.CheckedInputStream;

/**
 * Size and metadata of a PNG file.
 *
 * @param size in pixels, which its compressed data can hold
 * @param linear whether its channels are linear light
 */
public record PngNotes(PictureSize size, Optional<Provenance> provenance, boolean linear) {
    private static final long SIGNATURE = 0x89504e470d0a1a0aL;
    private static final int LONGEST_TEXT = 1 << 16;
    private static final int LINEAR_GAMMA = 100_000;

    /**
     * Reads a complete file.
     *
     * @throws IOException if it is no PNG, ends before its last chunk, has a wrong checksum, or claims more pixels than
     *     its data can hold
     */
    public static PngNotes of(Path file) throws IOException {
        try (InputStream bytes = InputFile.open(file);
                CheckedInputStream checked = new CheckedInputStream(new BufferedInputStream(bytes), new CRC32());
                DataInputStream in = new DataInputStream(checked)) {
            if (in.readLong() != SIGNATURE) {
                throw new IOException(file + " is no PNG");
            }
            PngHeader header = PngHeader.read(file, in);
            Map<String, String> texts = new HashMap<>();
            boolean linear = false;
            long dataBytes = 0;
            String type;
            do {
                int length = in.readInt();
                checked.getChecksum().reset();
                type = new String(in.readNBytes(Integer.BYTES), StandardCharsets.US_ASCII);
                dataBytes += type.equals("IDAT") ? Integer.toUnsignedLong(length) : 0;
                if (type.equals("gAMA")) {
                    linear = in.readInt() == LINEAR_GAMMA;
                } else if (type.equals("tEXt") && length >= 0 && length <= LONGEST_TEXT) {
                    put(texts, new String(in.readNBytes(length), StandardCharsets.ISO_8859_1));
                } else {
                    in.skipNBytes(Integer.toUnsignedLong(length));
                }
                int checksum = (int) checked.getChecksum().getValue();
                if (in.readInt() != checksum) {
                    throw new IOException(file + " is damaged: a checksum is wrong");
                }
            } while (!type.equals("IEND"));
            if (!Deflate.canHold(dataBytes, header.uncompressedBytes())) {
                throw new IOException(file + ": a PNG of " + header.uncompressedBytes() + " bytes cannot come from "
                        + dataBytes + " compressed ones");
            }
            return new PngNotes(header.size(), provenance(texts), linear);
        } catch (EOFException problem) {
            throw new IOException(file + " is not whole: it ends before its last chunk", problem);
        }
    }

    private static void put(Map<String, String> texts, String text) {
        int end = text.indexOf('\0');
        if (end > 0) {
            texts.put(text.substring(0, end), text.substring(end + 1));
        }
    }

    private static Optional<Provenance> provenance(Map<String, String> texts) {
        return Optional.ofNullable(texts.get(Provenance.NAME))
                .flatMap(text -> Provenance.of(texts.getOrDefault(Provenance.SOFTWARE, ""), text));
    }

    /**
     * The first chunk of a PNG file.
     *
     * @param bits per channel
     * @param channels per pixel
     */
    private record PngHeader(PictureSize size, int bits, int channels) {
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
}
