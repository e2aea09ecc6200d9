package dev.twister.image;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * What a PNG file says beside its pixels.
 *
 * @param linear whether its channels are linear light
 */
public record PngNotes(Optional<Provenance> provenance, boolean linear) {
    private static final long SIGNATURE = 0x89504e470d0a1a0aL;
    private static final int CHECKSUM_BYTES = 4;
    private static final int LONGEST_TEXT = 1 << 16;
    private static final int LINEAR_GAMMA = 100_000;

    /**
     * Reads a file that is whole.
     *
     * @throws IOException where it is no PNG, or ends before its last chunk
     */
    public static PngNotes of(Path file) throws IOException {
        try (InputStream bytes = Files.newInputStream(file);
                DataInputStream in = new DataInputStream(new BufferedInputStream(bytes))) {
            if (in.readLong() != SIGNATURE) {
                throw new IOException(file + " is no PNG");
            }
            Map<String, String> texts = new HashMap<>();
            boolean linear = false;
            String type;
            do {
                int length = in.readInt();
                type = new String(in.readNBytes(Integer.BYTES), StandardCharsets.US_ASCII);
                if (type.equals("gAMA")) {
                    linear = in.readInt() == LINEAR_GAMMA;
                    in.skipNBytes(CHECKSUM_BYTES);
                } else if (type.equals("tEXt") && length >= 0 && length <= LONGEST_TEXT) {
                    put(texts, new String(in.readNBytes(length), StandardCharsets.ISO_8859_1));
                    in.skipNBytes(CHECKSUM_BYTES);
                } else {
                    in.skipNBytes(Integer.toUnsignedLong(length) + CHECKSUM_BYTES);
                }
            } while (!type.equals("IEND"));
            return new PngNotes(provenance(texts), linear);
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
}
