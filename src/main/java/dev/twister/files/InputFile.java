package dev.twister.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Optional;

/** Checks what a path leads to before it is opened as a file: opening a FIFO blocks, and a device may never end. */
public final class InputFile {
    private static final int KIND = 0xf000;
    private static final int FIFO = 0x1000;
    private static final int CHARACTER_DEVICE = 0x2000;
    private static final int BLOCK_DEVICE = 0x6000;
    private static final int SOCKET = 0xc000;

    private InputFile() {}

    /**
     * Why a path cannot be opened as a file: {@code file not found}, {@code is a folder, but must be a file} and the
     * like. Empty for a regular file or a link to one.
     */
    public static Optional<String> problem(Path file) {
        try {
            BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
            return attributes.isRegularFile()
                    ? Optional.empty()
                    : Optional.of(
                            "is " + (attributes.isDirectory() ? "a folder" : kind(file)) + ", but must be a file");
        } catch (IOException failure) {
            return Optional.of(SystemReason.of(failure));
        }
    }

    /**
     * Checks a path.
     *
     * @throws IOException if it has a {@link #problem}, which is the message, without the file's name
     */
    public static void check(Path file) throws IOException {
        Optional<String> problem = problem(file);
        if (problem.isPresent()) {
            throw new IOException(problem.get());
        }
    }

    /**
     * Opens a file.
     *
     * @throws IOException with the file's name and the reason
     */
    public static InputStream open(Path file) throws IOException {
        try {
            check(file);
            return Files.newInputStream(file);
        } catch (IOException failure) {
            throw new IOException(file + ": " + SystemReason.of(failure), failure);
        }
    }

    /**
     * Reads a file of Twister's own whole, in whose place there may be anything by now.
     *
     * @throws IOException where it cannot be read, is larger than that, or is a pipe or a device, which could block or
     *     never end
     */
    public static byte[] readSmall(Path file, int mostBytes) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new IOException("not a regular file");
        }
        try (InputStream in = Files.newInputStream(file)) {
            byte[] bytes = in.readNBytes(mostBytes + 1);
            if (bytes.length > mostBytes) {
                throw new IOException("more than " + mostBytes + " bytes");
            }
            return bytes;
        }
    }

    private static String kind(Path file) throws IOException {
        int mode;
        try {
            mode = (int) Files.getAttribute(file, "unix:mode");
        } catch (UnsupportedOperationException | IllegalArgumentException _) {
            mode = 0;
        }
        return switch (mode & KIND) {
            case FIFO -> "a FIFO";
            case CHARACTER_DEVICE, BLOCK_DEVICE -> "a device";
            case SOCKET -> "a socket";
            default -> "a special file";
        };
    }
}
