package dev.twister.files;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.UUID;

/** The name of a file that is to be gone when it is closed, and where the process ends before that, too. */
final class TemporaryFile implements AutoCloseable {
    private final Path path;
    private final Thread hook = Thread.ofPlatform().name("temporary file").unstarted(this::deleteIfPossible);

    private TemporaryFile(Path path) {
        this.path = path;
    }

    /** One in the same folder, which nobody makes yet. */
    static TemporaryFile beside(Path place) {
        // Not Files.createTempFile: its files are readable by their owner only, and the finished file would stay so.
        TemporaryFile temporary = new TemporaryFile(place.resolveSibling("." + UUID.randomUUID() + ".tmp"));
        try {
            Runtime.getRuntime().addShutdownHook(temporary.hook);
        } catch (IllegalStateException _) {
            // The process ends already, and what is written now is written because of that.
        }
        return temporary;
    }

    Path path() {
        return path;
    }

    private void deleteIfPossible() {
        try {
            Files.deleteIfExists(path);
        } catch (IOException _) {
            // Some systems delete no file that is open. The process ends: nobody is left to tell.
        }
    }

    @Override
    public void close() throws IOException {
        try {
            Files.deleteIfExists(path);
        } finally {
            release();
        }
    }

    private void release() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException _) {
            // The process ends: the hook finds nothing to delete.
        }
    }
}
