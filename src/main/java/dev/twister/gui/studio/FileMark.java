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
 * Tells whether a file's content is still the same.
 *
 * @param digest SHA-256 of the content, in hexadecimal digits; empty if no file can be read
 */
public record FileMark(String digest) {
    /** No file that can be read. */
    public static final FileMark NONE = new FileMark("");

    /** Reads the file whole. */
    public static FileMark of(Path file) {
        if (!Files.isRegularFile(file)) {
            return NONE;
        }
        MessageDigest digest = sha256();
        try (InputStream in = new DigestInputStream(Files.newInputStream(file), digest)) {
            in.transferTo(OutputStream.nullOutputStream());
            return new FileMark(HexFormat.of().formatHex(digest.digest()));
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
