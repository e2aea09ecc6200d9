package dev.twister.files;

import java.io.File;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.locks.LockSupport;

/**
 * A file that is gone when this is closed, unless it was moved into place, and also where the process ends before that.
 * While it is written it is locked, so that other processes can tell it from what a killed one has left.
 */
final class TemporaryFile implements AutoCloseable {
    private static final String START = ".twister-";
    private static final String END = ".tmp";
    private static final Duration MADE_AND_LOCKED = Duration.ofMillis(100);

    /** On Windows nothing can be replaced while another program, such as a virus scanner, has it open. */
    private static final boolean OPEN_FILES_STAY = File.separatorChar == '\\';

    private static final int MOVES = 50;
    private static final Duration BETWEEN_MOVES = Duration.ofMillis(40);

    private final Path place;
    private final Path path;
    private final Thread hook = Thread.ofPlatform().name("temporary file").unstarted(this::end);

    /** Guarded by this object's lock, as is whatever makes the file: it must not be made after it was deleted. */
    private boolean ended;

    private Optional<FileLock> lock = Optional.empty();

    private TemporaryFile(Path place) {
        this.place = place;
        // Not Files.createTempFile: its files are readable by their owner only, and the finished file would stay so.
        path = place.resolveSibling(START + ProcessId.TEXT + "-" + UUID.randomUUID() + END);
    }

    /**
     * One that is to be moved to a place, in the same folder; nobody makes it yet.
     *
     * @throws IOException where the process ends already, and this thread has no {@link LastWrites}
     */
    static TemporaryFile of(Path place) throws IOException {
        TemporaryFile temporary = new TemporaryFile(place);
        try {
            Runtime.getRuntime().addShutdownHook(temporary.hook);
        } catch (IllegalStateException _) {
            LastWrites.check();
        }
        return temporary;
    }

    /** Makes the file, with the permissions of the one that it replaces, and opens it for writing. */
    synchronized FileChannel create() throws IOException {
        checkNotEnded();
        Optional<Set<PosixFilePermission>> permissions = permissions();
        FileChannel channel = FileChannel.open(
                path,
                Set.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.READ, StandardOpenOption.WRITE),
                permissions
                        .map(PosixFilePermissions::asFileAttribute)
                        .map(attribute -> new FileAttribute<?>[] {attribute})
                        .orElseGet(() -> new FileAttribute<?>[0]));
        if (permissions.isPresent()) {
            // The process's mask was taken from those at the creation.
            Files.setPosixFilePermissions(path, permissions.get());
        }
        try {
            lock = Optional.ofNullable(channel.tryLock());
        } catch (IOException _) {
            // Some file systems have no locks: then nobody takes what is left there for a killed process's.
        }
        return channel;
    }

    /** Lets another program write the file. On Windows a lock would keep it out, and an open file cannot be deleted. */
    synchronized void share() throws IOException {
        if (OPEN_FILES_STAY && lock.isPresent()) {
            lock.get().release();
        }
    }

    Path path() {
        return path;
    }

    /** Gives the finished file its name, where it replaces what was there; on Windows within two seconds. */
    synchronized void moveIntoPlace() throws IOException {
        checkNotEnded();
        for (int left = MOVES; ; left--) {
            try {
                move();
                return;
            } catch (AccessDeniedException denied) {
                if (!OPEN_FILES_STAY || left == 0) {
                    throw denied;
                }
                LockSupport.parkNanos(BETWEEN_MOVES.toNanos());
            }
        }
    }

    private void move() throws IOException {
        try {
            Files.move(path, place, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException notHere) {
            Files.move(path, place, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private Optional<Set<PosixFilePermission>> permissions() throws IOException {
        try {
            return Optional.of(Files.getPosixFilePermissions(place));
        } catch (NoSuchFileException | UnsupportedOperationException _) {
            return Optional.empty();
        }
    }

    private void checkNotEnded() throws IOException {
        if (ended) {
            throw new IOException(LastWrites.REFUSAL);
        }
    }

    /** The process ends. */
    synchronized void end() {
        ended = true;
        deleteIfPossible(path);
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

    /** Deletes what killed processes have left in a folder, as far as that is possible. */
    static void deleteLeftovers(Path folder) {
        // A younger one may be made by another process, but not locked yet.
        Instant youngest = Instant.now().minus(MADE_AND_LOCKED);
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, START + "*" + END)) {
            for (Path file : files) {
                if (!ProcessId.isOwn(file, START)
                        && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                        && Files.getLastModifiedTime(file).toInstant().isBefore(youngest)
                        && !isWritten(file)) {
                    deleteIfPossible(file);
                }
            }
        } catch (IOException _) {
            // Files left behind only clutter the folder: no reason to stop.
        }
    }

    private static boolean isWritten(Path file) {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
            return channel.tryLock() == null;
        } catch (IOException | OverlappingFileLockException _) {
            return true;
        }
    }

    private static void deleteIfPossible(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException _) {
            // Some systems delete no file that is open. The process ends, or the file is an old one: nobody is left to
            // tell.
        }
    }

    /**
     * The number of this process in the names of temporary files. A process must not look at the locks of its own
     * files: on some systems that releases them.
     */
    static final class ProcessId {
        static final String TEXT = Long.toString(ProcessHandle.current().pid());

        private ProcessId() {}

        /** Whether a temporary file is this process's: {@code start} and this number are followed by a hyphen. */
        static boolean isOwn(Path file, String start) {
            return file.getFileName().toString().startsWith(start + TEXT + "-");
        }
    }
}
