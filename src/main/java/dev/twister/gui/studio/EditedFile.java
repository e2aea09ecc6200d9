package dev.twister.gui.studio;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * A scene's file as it was when it was opened or saved last.
 *
 * @param mark of its content then
 */
public record EditedFile(Path path, Digest mark) {
    /** Whether to write there replaces what another program has written since; reads the file. */
    public boolean isOverwrittenBy(Path target) {
        if (!absolute(target).equals(absolute(path))) {
            return false;
        }
        Digest now = Digest.of(path);
        return !now.equals(Digest.NONE) && !now.equals(mark);
    }

    private static Path absolute(Path file) {
        return file.toAbsolutePath().normalize();
    }

    /**
     * Tells whether a file's content is still the same.
     *
     * @param digest SHA-256 of the content, in hexadecimal digits; empty if no file can be read
     */
    public record Digest(String digest) {
        /** No file that can be read. */
        public static final Digest NONE = new Digest("");

        /** Reads the file whole. */
        public static Digest of(Path file) {
            if (!Files.isRegularFile(file)) {
                return NONE;
            }
            MessageDigest digest = sha256();
            try (InputStream in = new DigestInputStream(Files.newInputStream(file), digest)) {
                in.transferTo(OutputStream.nullOutputStream());
                return new Digest(HexFormat.of().formatHex(digest.digest()));
            } catch (IOException _) {
                return NONE;
            }
        }

        private static MessageDigest sha256() {
            try {
                return MessageDigest.getInstance("SHA-256");
            } catch (NoSuchAlgorithmException impossible) {
                // Every Java platform has it.
                throw new IllegalStateException(impossible);
            }
        }
    }
}
