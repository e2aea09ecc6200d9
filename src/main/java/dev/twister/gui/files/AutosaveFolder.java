package dev.twister.gui.files;

import dev.twister.files.UserFolder;
import dev.twister.files.WholeFile;
import dev.twister.gui.studio.EditedFile;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneWriter;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.UUID;

/**
 * The folder in which unsaved edits outlive a killed process. Each has a scene file and a second file that names what
 * was edited and is locked while the editing process lives. Several processes share the folder.
 *
 * @param folder created when first needed; empty if this user has none, and then nothing is kept
 * @param delay from an edit to writing it, together with later edits
 */
public record AutosaveFolder(Optional<Path> folder, Duration delay) {
    private static final String SCENE = ".json";
    private static final String LOCK = ".lock";

    /** Much longer than it takes to lock the new file and to write its scene. */
    private static final Duration BEGUN = Duration.ofMinutes(10);

    /** Edits are written after 3 seconds. */
    public AutosaveFolder(Optional<Path> folder) {
        this(folder, Duration.ofSeconds(3));
    }

    public static AutosaveFolder ofThisUser() {
        return new AutosaveFolder(UserFolder.STATE.ofThisUser().map(own -> own.resolve("autosave")));
    }

    /**
     * A place for unsaved edits of a file, nothing written there yet.
     *
     * @throws IOException if it cannot be created
     */
    public Autosave begin(EditedFile edited) throws IOException {
        Path place = folder.orElseThrow(() -> new IOException("this user has no folder for it"));
        Files.createDirectories(place);
        String name = UUID.randomUUID().toString();
        Path lockFile = place.resolve(name + LOCK);
        FileChannel channel = FileChannel.open(
                lockFile, StandardOpenOption.CREATE_NEW, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            // Before there is a scene, which others look for.
            if (channel.tryLock() == null) {
                throw new IOException(lockFile + " is locked by another program");
            }
            channel.write(ByteBuffer.wrap(
                    (edited.mark().digest() + "\n" + edited.path().toAbsolutePath()).getBytes(StandardCharsets.UTF_8)));
        } catch (IOException | RuntimeException problem) {
            channel.close();
            Files.deleteIfExists(lockFile);
            throw problem;
        }
        return new Autosave(lockFile, channel, place.resolve(name + SCENE), edited);
    }

    /**
     * What processes have left that live no more, the newest first; to be closed or deleted each. Called before this
     * process begins any: on some systems to look at a lock of one's own is to lose it.
     */
    public List<Autosave> leftBehind() {
        if (folder.isEmpty() || !Files.isDirectory(folder.get())) {
            return List.of();
        }
        WholeFile.deleteLeftovers(folder.get());
        List<Autosave> found = new ArrayList<>();
        try (DirectoryStream<Path> locks = Files.newDirectoryStream(folder.get(), "*" + LOCK)) {
            locks.forEach(lockFile -> find(lockFile).ifPresent(found::add));
        } catch (IOException | DirectoryIteratorException _) {
            // What cannot be looked at stays for the next time.
        }
        found.sort(Comparator.comparing(Autosave::written).reversed());
        return found;
    }

    private static Optional<Autosave> find(Path lockFile) {
        String name = lockFile.getFileName().toString();
        Path scene = lockFile.resolveSibling(name.substring(0, name.length() - LOCK.length()) + SCENE);
        try {
            if (!Files.exists(scene)) {
                deleteAbandoned(lockFile);
                return Optional.empty();
            }
            Optional<FileChannel> lock = lock(lockFile);
            return lock.isPresent() ? found(lockFile, lock.get(), scene) : Optional.empty();
        } catch (IOException _) {
            return Optional.empty();
        }
    }

    private static Optional<Autosave> found(Path lockFile, FileChannel lock, Path scene) throws IOException {
        // Its process may have deleted the scene and ended meanwhile.
        Optional<EditedFile> edited = Files.exists(scene) ? edited(lock) : Optional.empty();
        if (edited.isEmpty()) {
            lock.close();
        }
        return edited.map(file -> new Autosave(lockFile, lock, scene, file));
    }

    private static Optional<FileChannel> lock(Path lockFile) throws IOException {
        FileChannel channel = FileChannel.open(lockFile, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            if (channel.tryLock() != null) {
                return Optional.of(channel);
            }
        } catch (IOException | OverlappingFileLockException _) {
            // As if another process had it.
        }
        channel.close();
        return Optional.empty();
    }

    private static Optional<EditedFile> edited(FileChannel lock) throws IOException {
        String text = new String(Channels.newInputStream(lock).readAllBytes(), StandardCharsets.UTF_8);
        int line = text.indexOf('\n');
        try {
            return line < 0
                    ? Optional.empty()
                    : Optional.of(new EditedFile(
                            Path.of(text.substring(line + 1)), new EditedFile.Digest(text.substring(0, line))));
        } catch (InvalidPathException _) {
            return Optional.empty();
        }
    }

    /** A process was killed before it had written its scene. */
    private static void deleteAbandoned(Path lockFile) throws IOException {
        if (Files.getLastModifiedTime(lockFile)
                .toInstant()
                .isBefore(Instant.now().minus(BEGUN))) {
            Optional<FileChannel> lock = lock(lockFile);
            if (lock.isPresent()) {
                Files.deleteIfExists(lockFile);
                lock.get().close();
            }
        }
    }

    /**
     * A scene's unsaved edits in a file of their own. As long as this is open, other processes leave it alone. Used by
     * one thread at a time.
     */
    public static final class Autosave implements AutoCloseable {
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
}
