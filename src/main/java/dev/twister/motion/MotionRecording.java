package dev.twister.motion;

import dev.twister.files.InputFile;
import dev.twister.files.SystemReason;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.Optional;

/**
 * Writes a motion file frame by frame; only one process at a time can. If the process is killed at any moment, the
 * complete frames remain valid, and the next recording continues after them. Messages of exceptions are one line and
 * name the file.
 */
public final class MotionRecording implements AutoCloseable {
    private final Path path;
    private final FileChannel channel;
    private final MotionHeader header;
    private int recorded;

    private MotionRecording(Path path, FileChannel channel, MotionHeader header, int recorded) {
        this.path = path;
        this.channel = channel;
        this.header = header;
        this.recorded = recorded;
    }

    /**
     * Creates a file, or continues an existing one.
     *
     * @param firstFrame number of the first frame, at least 0
     * @param rate frames per second
     * @throws IOException if the file exists with other content, is being written by another process, or cannot be
     *     written
     */
    public static MotionRecording open(Path path, Scene scene, int firstFrame, double rate) throws IOException {
        Optional<String> problem = Files.exists(path) ? InputFile.problem(path) : Optional.empty();
        if (problem.isPresent()) {
            throw new IOException("cannot write " + path + ": " + problem.get());
        }
        MotionHeader header = MotionHeader.of(scene, firstFrame, rate);
        FileChannel channel;
        try {
            channel = FileChannel.open(
                    path, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        } catch (IOException failure) {
            throw new IOException("cannot write " + path + ": " + SystemReason.of(failure), failure);
        }
        try {
            lock(path, channel);
            return new MotionRecording(path, channel, header, begin(path, channel, header, scene));
        } catch (IOException failure) {
            channel.close();
            throw failure;
        }
    }

    private static void lock(Path path, FileChannel channel) throws IOException {
        Optional<FileLock> lock;
        try {
            lock = Optional.ofNullable(channel.tryLock());
        } catch (OverlappingFileLockException _) {
            lock = Optional.empty();
        }
        if (lock.isEmpty()) {
            throw new IOException(path + " is being written by another process");
        }
    }

    /** The number of complete frames; removes anything after them. */
    private static int begin(Path path, FileChannel channel, MotionHeader header, Scene scene) throws IOException {
        byte[] wanted = header.encoded();
        if (channel.size() < wanted.length) {
            ByteBuffer there = ByteBuffer.allocate((int) channel.size());
            channel.read(there, 0);
            if (!Arrays.equals(there.array(), Arrays.copyOf(wanted, there.capacity()))) {
                throw new IOException(path + " is there and is not a motion file; give another name");
            }
            channel.write(ByteBuffer.wrap(wanted), 0);
            return 0;
        }
        MotionHeader found = MotionFile.header(path, channel);
        MotionFile.checkIsOf(path, found, scene);
        if (!found.equals(header)) {
            throw new IOException(path + " begins with frame " + found.firstFrame() + " at " + found.rate()
                    + " frames per second, not with frame " + header.firstFrame() + " at " + header.rate()
                    + "; give another name");
        }
        int frames = MotionFile.wholeFrames(channel, header);
        while (frames > 0 && !isWhole(channel, header, header.firstFrame() + frames - 1)) {
            frames--;
        }
        channel.truncate(end(header, frames));
        return frames;
    }

    private static boolean isWhole(FileChannel channel, MotionHeader header, int number) throws IOException {
        try {
            MotionFrame.decode(MotionFile.bytes(channel, header, number).orElseThrow());
            return true;
        } catch (IOException _) {
            return false;
        }
    }

    private static long end(MotionHeader header, int frames) {
        return MotionHeader.BYTES + (long) frames * header.frameBytes();
    }

    /** Number of the next frame. */
    public int nextFrame() {
        return header.firstFrame() + recorded;
    }

    /** Required origin of the positions, in the scene's coordinates, in meters. */
    public Vector3 origin() {
        return header.origin();
    }

    /**
     * Writes the next frame, or checks that an earlier one is unchanged.
     *
     * @param number number of the next frame or of an earlier one in the file
     * @throws IOException if the file holds a different frame, or the disk is full
     */
    public void put(int number, MotionFrame frame) throws IOException {
        byte[] encoded = frame.encoded();
        if (number < nextFrame()) {
            if (!MotionFile.bytes(channel, header, number)
                    .map(old -> Arrays.equals(old, encoded))
                    .orElse(false)) {
                throw new IOException(path + ": frame " + number + " is not what this version of Twister simulates;"
                        + " delete the file, or give another name");
            }
            return;
        }
        long place = end(header, recorded);
        ByteBuffer bytes = ByteBuffer.wrap(encoded);
        try {
            while (bytes.hasRemaining()) {
                channel.write(bytes, place + bytes.position());
            }
        } catch (IOException failure) {
            throw new IOException("cannot write " + path + ": " + SystemReason.of(failure), failure);
        }
        recorded++;
    }

    @Override
    public void close() throws IOException {
        try (channel) {
            channel.force(true);
        }
    }
}
