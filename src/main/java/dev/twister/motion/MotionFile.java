package dev.twister.motion;

import dev.twister.files.SystemReason;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/**
 * A motion file that is read by frame number; it may still be written meanwhile. Messages of exceptions are one line
 * and name the file.
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
     * Opens a scene's motion.
     *
     * @throws IOException where the file cannot be read, is no motion file, or is that of a scene whose bodies move
     *     differently
     */
    public static MotionFile open(Path path, Scene scene) throws IOException {
        if (!Files.isRegularFile(path)) {
            throw new IOException(path + (Files.exists(path) ? " is not a regular file" : ": file not found"));
        }
        FileChannel channel;
        try {
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

    /** The number of the first frame. */
    public int firstFrame() {
        return header.firstFrame();
    }

    /**
     * The number of the last whole frame; one below the first where there is none.
     *
     * @throws IOException whatever the disk reported
     */
    public int lastFrame() throws IOException {
        return header.firstFrame() + wholeFrames(channel, header) - 1;
    }

    static int wholeFrames(FileChannel channel, MotionHeader header) throws IOException {
        long frames = Math.max(0, channel.size() - MotionHeader.BYTES) / header.frameBytes();
        return (int) Math.min(Integer.MAX_VALUE - header.firstFrame(), frames);
    }

    /** Frames a second. */
    public double rate() {
        return header.rate();
    }

    /** Light, plane and all spheres, poured or not. */
    public int bodies() {
        return header.bodies();
    }

    /** What positions are relative to, in the scene's coordinates, in meters. */
    public Vector3 origin() {
        return header.origin();
    }

    /**
     * Reads a frame.
     *
     * @throws IOException where it is not in the file, or damaged
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

    /**
     * Moves a world's bodies to where they are in a frame; it must be of the same scene.
     *
     * @throws IOException where the frame is not in the file, or damaged
     */
    public void place(World world, int number) throws IOException {
        MotionFrame frame = frame(number);
        float[] positions = frame.positions();
        Vector3 from = header.origin();
        Vector3 to = world.origin();
        if (!from.equals(to)) {
            double[] shift = {from.x() - to.x(), from.y() - to.y(), from.z() - to.z()};
            for (int i = 0; i < positions.length; i++) {
                positions[i] = (float) (positions[i] + shift[i % 3]);
            }
        }
        world.setBodyPositions(positions, frame.present());
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
