package dev.twister.files;

import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;

/** Writes a file whole or not at all: readers of its path see the old content or the new, never a part. */
public final class WholeFile {
    /** Written to in place of a file of that name in the current folder, which is {@code ./-}. */
    public static final Path STANDARD_OUTPUT = Path.of("-");

    private static final int BUFFER_BYTES = 1 << 16;

    /** As many links as systems follow. */
    private static final int MOST_LINKS = 40;

    /** What a file is to hold. */
    @FunctionalInterface
    public interface Content {
        /** Writes everything to a buffered stream, which it need not close. */
        void writeTo(OutputStream out) throws IOException;
    }

    private WholeFile() {}

    /**
     * Replaces a file as {@link #replace} does, and tells what failed; a device, a pipe and {@link #STANDARD_OUTPUT}
     * are written to directly.
     *
     * @throws IOException naming the target and the cause: no such folder, the target is a folder, no permission, or
     *     whatever the disk or the content reported
     */
    public static void write(Path target, Content content) throws IOException {
        if (target.equals(STANDARD_OUTPUT)) {
            writeToStandardOutput(content);
            return;
        }
        if (Files.isDirectory(target)) {
            throw new IOException("cannot write " + target + ": it is a folder");
        }
        try {
            if (Files.exists(target) && !Files.isRegularFile(target)) {
                // A move would replace the device itself, /dev/null for one.
                try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(target), BUFFER_BYTES)) {
                    content.writeTo(out);
                }
            } else {
                replace(target, content);
            }
        } catch (IOException failure) {
            throw explained(target, failure);
        }
    }

    private static void writeToStandardOutput(Content content) throws IOException {
        // Not System.out, which hides errors. Not closed, as more may follow.
        OutputStream out = new BufferedOutputStream(new FileOutputStream(FileDescriptor.out), BUFFER_BYTES);
        try {
            content.writeTo(out);
            out.flush();
        } catch (IOException failure) {
            throw new IOException("cannot write to standard output: " + SystemReason.of(failure), failure);
        }
    }

    /** The failure of writing a file as an exception whose message names the file and the cause, on one line. */
    public static IOException explained(Path target, IOException failure) throws IOException {
        String cause = switch (failure) {
            case NoSuchFileException _ -> {
                Path folder = behindLinks(target).getParent();
                // Systems say so of folders such as /proc too.
                boolean isThere = folder != null && Files.isDirectory(folder);
                yield isThere ? "no file can be made there" : "there is no folder " + folder;
            }
            case AccessDeniedException _ ->
                "no permission in the folder " + behindLinks(target).getParent();
            // Not its message, which has the temporary file's name.
            default -> SystemReason.of(failure);
        };
        return new IOException("cannot write " + target + ": " + cause, failure);
    }

    /**
     * Streams the content into a temporary file in the target's own folder, waits until it is safely on the disk, and
     * moves it into place, replacing what was there, with the same permissions. A failure of any kind, and the end of
     * the process, leaves the target as it was and no temporary file behind; a process that is killed without a word
     * leaves one ({@link #deleteLeftovers}). While the process ends, only {@link LastWrites} are begun. A symbolic link
     * stays, and the file it leads to is replaced, or made where it was not there.
     *
     * @param target no folder or device
     * @throws IOException whatever the disk or the content reported
     */
    public static void replace(Path target, Content content) throws IOException {
        try (FileReplacement replacement = FileReplacement.of(target)) {
            content.writeTo(replacement.out());
            replacement.finish();
        }
    }

    /**
     * Begins a file as {@link #replace} does, and leaves everything as it was.
     *
     * @param target no folder or device
     * @throws IOException if no file of that name can be made there, as the system reports it
     */
    public static void tryToReplace(Path target) throws IOException {
        try {
            Files.readAttributes(behindLinks(target), BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
        } catch (NoSuchFileException _) {
            // The system takes the name.
        }
        FileReplacement.of(target).close();
    }

    /**
     * Deletes temporary files that killed processes have left in a folder. What a living process writes, on this
     * machine or another one, stays; so does what cannot be deleted.
     */
    public static void deleteLeftovers(Path folder) {
        TemporaryFile.deleteLeftovers(folder);
    }

    /**
     * Where a file that is written is to be, absolute: links need not lead to one that is there.
     *
     * @throws IOException where links cannot be followed, because they lead to one another say
     */
    public static Path behindLinks(Path target) throws IOException {
        Path place = target.toAbsolutePath();
        for (int links = 0; Files.isSymbolicLink(place); links++) {
            if (links == MOST_LINKS) {
                throw new FileSystemException(target.toString(), null, "its links lead to one another");
            }
            place = place.resolveSibling(Files.readSymbolicLink(place));
        }
        return place;
    }
}
