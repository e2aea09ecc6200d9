package dev.twister.motion;

import dev.twister.files.InputFile;
import dev.twister.files.SystemReason;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/**
 * Reads a motion file by frame number, even while it is being written. Messages of exceptions are one line and name the
 * file.
 */
public final class MotionFile implements AutoCloseable {
    private static final String CONTINUE = "; 'twister simulate' with the same options completes it";

    private final Path path;
    private final FileChannel channel;
    private final MotionHeader header;

    private MotionFile(Path path, FileChannel channel, MotionHeader header) {
        this.path = path;
        this.channel = channel;
        this.header = header;
    }

    /**
     * Opens the motion file of a scene.
     *
     * @throws IOException if the file cannot be read, is not a motion file, or belongs to a scene with different motion
     */
    public static MotionFile open(Path path, Scene scene) throws IOException {
        FileChannel channel;
        try {
            InputFile.check(path);
            channel = FileChannel.open(path, StandardOpenOption.READ);
        } catch (IOException failure) {
            throw new IOException(path + ": " + SystemReason.of(failure), failure);
        }
        try {
            MotionHeader header = header(path, channel);
            checkIsOf(path, header, scene);
            return new MotionFile(path, channel, header);
        } catch (IOException failure) {
            channel.close();
            throw failure;
        }
    }

    static MotionHeader header(Path path, FileChannel channel) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(MotionHeader.BYTES);
        if (!fill(buffer, channel, 0)) {
            throw new IOException(path + " is not a motion file: it has fewer than " + MotionHeader.BYTES + " bytes");
        }
        try {
            return MotionHeader.decode(buffer.array());
        } catch (IOException problem) {
            throw new IOException(path + ": " + problem.getMessage(), problem);
        }
    }

    static void checkIsOf(Path path, MotionHeader header, Scene scene) throws IOException {
        MotionHeader expected = MotionHeader.of(scene, header.firstFrame(), header.rate());
        if (!header.digest().equals(expected.digest()) || header.bodies() != expected.bodies()) {
            throw new IOException(path + " has the motion of another scene, or of this one before its bodies, walls or"
                    + " forces were edited; give another file, or simulate again");
        }
    }

    /** Number of the first frame. */
    public int firstFrame() {
        return header.firstFrame();
    }

    /**
     * Number of the last complete frame; one less than the first if there is none.
     *
     * @throws IOException if the disk reports an error
     */
    public int lastFrame() throws IOException {
        return header.firstFrame() + wholeFrames(channel, header) - 1;
    }

    static int wholeFrames(FileChannel channel, MotionHeader header) throws IOException {
        long frames = Math.max(0, channel.size() - MotionHeader.BYTES) / header.frameBytes();
        return (int) Math.min(Integer.MAX_VALUE - header.firstFrame(), frames);
    }

    /** Frames per second. */
    public double rate() {
        return header.rate();
    }

    /** Number of bodies: light, plane and all spheres, including those not poured yet. */
    public int bodies() {
        return header.bodies();
    }

    /** Origin of the positions, in the scene's coordinates, in meters. */
    public Vector3 origin() {
        return header.origin();
    }

    /**
     * Reads a frame.
     *
     * @throws IOException if the frame is not in the file or is damaged
     */
    public MotionFrame frame(int number) throws IOException {
        if (number < firstFrame()) {
            throw new IOException(path + " begins with frame " + firstFrame() + ", but frame " + number
                    + " is wanted; simulate it into another file");
        }
        Optional<byte[]> bytes = bytes(channel, header, number);
        if (bytes.isEmpty()) {
            int last = lastFrame();
            throw new IOException(path + " ends "
                    + (last < firstFrame() ? "before its first frame" : "with frame " + last) + ", but frame " + number
                    + " is wanted" + CONTINUE);
        }
        try {
            return MotionFrame.decode(bytes.get());
        } catch (IOException problem) {
            throw new IOException(
                    path + ": frame " + number + " is damaged: " + problem.getMessage() + "; simulate again", problem);
        }
    }

    static Optional<byte[]> bytes(FileChannel channel, MotionHeader header, int number) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(header.frameBytes());
        long place = MotionHeader.BYTES + (long) header.frameBytes() * (number - header.firstFrame());
        return fill(buffer, channel, place) ? Optional.of(buffer.array()) : Optional.empty();
    }

    private static boolean fill(ByteBuffer buffer, FileChannel channel, long place) throws IOException {
        int read = 0;
        while (buffer.hasRemaining() && read >= 0) {
            read = channel.read(buffer, place + buffer.position());
        }
        return !buffer.hasRemaining();
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
