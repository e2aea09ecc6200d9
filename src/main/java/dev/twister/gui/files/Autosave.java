package dev.twister.gui.files;

import dev.twister.gui.studio.EditedFile;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneWriter;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;

/**
 * A scene's unsaved edits in a file of their own. As long as this is open, other processes leave it alone. Used by one
 * thread at a time.
 */
public final class Autosave implements AutoCloseable {
    private final Path lockFile;
    private final FileChannel lock;
    private final Path file;
    private final EditedFile edited;

    /**
     * @param lock holds the lock of that file
     * @param file the file of the edited scene, which may not exist yet
     */
    Autosave(Path lockFile, FileChannel lock, Path file, EditedFile edited) {
        this.lockFile = lockFile;
        this.lock = lock;
        this.file = file;
        this.edited = edited;
    }

    /** The file that was edited. */
    public EditedFile edited() {
        return edited;
    }

    /** Where the edited scene is. */
    public Path file() {
        return file;
    }

    /** When the edits were last written; the epoch if the system does not know. */
    public Instant written() {
        try {
            return Files.getLastModifiedTime(file).toInstant();
        } catch (IOException _) {
            return Instant.EPOCH;
        }
    }

    /**
     * Keeps the scene as it is now, whole or not at all.
     *
     * @throws dev.twister.scene.SceneException if it cannot be written; the message is one line
     */
    public void write(Scene scene) {
        SceneWriter.write(scene, file);
    }

    /** The edits are saved or given up. */
    public void delete() throws IOException {
        try (this) {
            Files.deleteIfExists(file);
            Files.deleteIfExists(lockFile);
        }
    }

    /** Keeps the autosaved edits for the next start. */
    @Override
    public void close() throws IOException {
        lock.close();
    }
}
