package dev.twister.files;

import dev.twister.files.TemporaryFile.ProcessId;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.DirectoryStream;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;

/**
 * A folder for temporary files, deleted with its content when it is closed or the process ends. Folders that killed
 * processes left are deleted when the next one is created. All temporary folders of the program are made here.
 */
public final class TemporaryFolder implements AutoCloseable {
    private static final String START = "twister-temporary-";
    private static final String LOCK = "lock";

    /** Long enough to lock a folder after its creation. */
    private static final Duration CREATED_AND_LOCKED = Duration.ofMinutes(1);

    private final Path path;
    private final FileChannel lock;
    private final Thread hook = Thread.ofPlatform().name("temporary folder").unstarted(this::deleteIfPossible);

    private TemporaryFolder(Path path) throws IOException {
        this.path = path;
        lock = FileChannel.open(path.resolve(LOCK), StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    }

    /**
     * Creates a folder in the system's folder for temporary files, for this user only.
     *
     * @throws IOException if that fails, or the process is ending
     */
    public static TemporaryFolder create() throws IOException {
        return create(Path.of(System.getProperty("java.io.tmpdir")));
    }

    public static TemporaryFolder create(Path parent) throws IOException {
        deleteLeftovers(parent);
        try {
            TemporaryFolder folder =
                    new TemporaryFolder(Files.createTempDirectory(parent, START + ProcessId.TEXT + "-"));
            Runtime.getRuntime().addShutdownHook(folder.hook);
            folder.lock.tryLock();
            return folder;
        } catch (IllegalStateException ending) {
            throw new IOException(LastWrites.REFUSAL, ending);
        } catch (IOException failure) {
            throw new IOException(
                    "cannot create a temporary folder in " + parent + ": " + SystemReason.of(failure), failure);
        }
    }

    public Path path() {
        return path;
    }

    @Override
    public void close() throws IOException {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException _) {
            // The process ends: the hook deletes the folder too.
        }
        lock.close();
        delete(path);
    }

    private void deleteIfPossible() {
        try {
            lock.close();
            delete(path);
        } catch (IOException _) {
            // The process ends. The next one tries again.
        }
    }

    private static void deleteLeftovers(Path parent) {
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(parent, START + "*")) {
            for (Path folder : folders) {
                if (!ProcessId.isOwn(folder, START) && isLeft(folder)) {
                    delete(folder);
                }
            }
        } catch (IOException _) {
            // Folders left behind only take room: no reason to stop.
        }
    }

    private static boolean isLeft(Path folder) {
        try {
            BasicFileAttributes attributes =
                    Files.readAttributes(folder, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
            Instant youngest = Instant.now().minus(CREATED_AND_LOCKED);
            return attributes.isDirectory()
                    && attributes.lastModifiedTime().toInstant().isBefore(youngest)
                    && !isLocked(folder.resolve(LOCK));
        } catch (IOException _) {
            return false;
        }
    }

    private static boolean isLocked(Path file) throws IOException {
        if (Files.notExists(file, LinkOption.NOFOLLOW_LINKS)) {
            return false;
        }
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS)) {
            Optional<FileLock> lock = Optional.ofNullable(channel.tryLock());
            return lock.isEmpty();
        }
    }

    private static void delete(Path folder) throws IOException {
        Files.walkFileTree(folder, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                Files.deleteIfExists(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFileFailed(Path file, IOException gone) {
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path visited, IOException failure) throws IOException {
                Files.deleteIfExists(visited);
                return FileVisitResult.CONTINUE;
            }
        });
    }
}
