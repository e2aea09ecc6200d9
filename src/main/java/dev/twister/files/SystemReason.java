package dev.twister.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Objects;
import java.util.Set;

/** Why something with a file failed, without the file: the caller names the one that the user knows. */
public final class SystemReason {
    /** What Linux and macOS, and Windows say of a full disk. */
    private static final Set<String> FULL = Set.of("No space left on device", "There is not enough space on the disk");

    private SystemReason() {}

    /** The system's own words where it had any, and words of ours where it left them out; one line. */
    public static String of(IOException failure) {
        return switch (failure) {
            // Their messages are the file's name alone.
            case NoSuchFileException _ -> "file not found";
            case FileAlreadyExistsException _ -> "a file of that name already exists";
            case AccessDeniedException _ -> "permission denied";
            case FileSystemException system -> orKind(system.getReason(), system);
            default -> orKind(failure.getMessage(), failure);
        };
    }

    private static String orKind(String words, IOException failure) {
        if (FULL.contains(String.valueOf(words))) {
            return "disk full";
        }
        return Objects.requireNonNullElse(words, failure.getClass().getSimpleName());
    }
}
