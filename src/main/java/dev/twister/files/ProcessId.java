package dev.twister.files;

import java.nio.file.Path;

/**
 * The number of this process in the names of temporary files. A process must not look at the locks of its own files: on
 * some systems that releases them.
 */
final class ProcessId {
    static final String TEXT = Long.toString(ProcessHandle.current().pid());

    private ProcessId() {}

    /** Whether a temporary file is this process's: {@code start} and this number are followed by a hyphen. */
    static boolean isOwn(Path file, String start) {
        return file.getFileName().toString().startsWith(start + TEXT + "-");
    }
}
