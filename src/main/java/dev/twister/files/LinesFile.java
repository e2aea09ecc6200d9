package dev.twister.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/** Appends lines to a file that several processes may append to at the same time. */
public final class LinesFile {
    private LinesFile() {}

    /**
     * Appends a line, whole or not at all. If the file does not end with a line feed, one is added first.
     *
     * @param line without its line feed
     * @throws IOException naming the file and the cause
     */
    public static void append(Path file, byte[] line) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            WholeFile.write(file, out -> {
                out.write(line);
                out.write('\n');
            });
            return;
        }
        try {
            // A lock is the process's: its threads take turns.
            synchronized (LinesFile.class) {
                appendLocked(file, line);
            }
        } catch (IOException failure) {
            throw WholeFile.explained(file, failure);
        }
    }

    private static void appendLocked(Path file, byte[] line) throws IOException {
        try (FileChannel channel =
                FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
            Optional<FileLock> lock = lock(channel);
            long end = channel.size();
            try {
                channel.position(end);
                write(channel, isEndOpen(channel, end), line);
                channel.force(true);
            } catch (IOException failure) {
                channel.truncate(end);
                throw failure;
            } finally {
                if (lock.isPresent()) {
                    lock.get().release();
                }
            }
        }
    }

    private static Optional<FileLock> lock(FileChannel channel) {
        try {
            return Optional.of(channel.lock());
        } catch (IOException _) {
            // Some file systems have no locks.
            return Optional.empty();
        }
    }

    private static boolean isEndOpen(FileChannel channel, long end) throws IOException {
        ByteBuffer last = ByteBuffer.allocate(1);
        return end > 0 && channel.read(last, end - 1) == 1 && last.get(0) != '\n';
    }

    private static void write(FileChannel channel, boolean isEndOpen, byte[] line) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(line.length + 2);
        if (isEndOpen) {
            bytes.put((byte) '\n');
        }
        bytes.put(line).put((byte) '\n').flip();
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }
}
