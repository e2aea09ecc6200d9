package dev.twister.motion;

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
 * A motion file that is written frame by frame, by one process at a time. After a kill at any moment its whole frames
 * count: the next recording goes on behind them. Messages of exceptions are one line and name the file.
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
     * Begins a file, or goes on with what is there.
     *
     * @param firstFrame its number, 0 or more
     * @param rate frames a second
     * @throws IOException where there is something else already, another process writes it, or it cannot be written
     */
    public static MotionRecording open(Path path, Scene scene, int firstFrame, double rate) throws IOException {
        if (Files.exists(path) && !Files.isRegularFile(path)) {
            throw new IOException(path + " is not a regular file");
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

    /** How many whole frames are there; what is behind them is cut off. */
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

    /** The number of the frame that comes next. */
    public int nextFrame() {
        return header.firstFrame() + recorded;
    }

    /** What positions must be relative to, in the scene's coordinates, in meters. */
    public Vector3 origin() {
        return header.origin();
    }

    /**
     * Takes a frame: the next one is written, an earlier one must be as it was.
     *
     * @param number the next frame's, or an earlier one's in the file
     * @throws IOException where the file has another motion, or the disk is full
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
