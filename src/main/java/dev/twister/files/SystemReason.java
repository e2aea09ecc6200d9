package dev.twister.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Objects;

/** Why something with a file failed, without the file: the caller names the one that the user knows. */
public final class SystemReason {
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
        return Objects.requireNonNullElse(words, failure.getClass().getSimpleName());
    }
}
