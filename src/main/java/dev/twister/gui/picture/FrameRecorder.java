package dev.twister.gui.picture;

import dev.twister.image.PngWriter;
import dev.twister.threads.BackgroundWriter;
import java.io.IOException;
import java.nio.IntBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Writes frames as numbered PNG files in the background. No frame is left out: if the disk or the encoder is slower
 * than the frames come, the caller waits.
 */
public final class FrameRecorder implements AutoCloseable {
    private static final Pattern NUMBERED = Pattern.compile("frame-([0-9]{6,9})\\.png");

    /** Limit of the frames that wait; a 4K frame has 33 MB. */
    private static final long MAX_WAITING_BYTES = 256L << 20;

    /** Writes a file; tests have slower ones. */
    @FunctionalInterface
    interface PictureWriter {
        void write(Path file, int width, int height, int[] argb, boolean srgb) throws IOException;
    }

    /**
     * Progress of a recording.
     *
     * @param written number of frames on the disk
     * @param waiting number of frames that are not written yet
     * @param failure why recording has stopped; empty if it has not failed
     */
    public record Progress(long written, int waiting, Optional<String> failure) {}

    private final Path folder;
    private final PictureWriter pictures;
    private final BackgroundWriter writer = new BackgroundWriter("twister-recorder", 1, MAX_WAITING_BYTES);
    private long nextNumber;

    private FrameRecorder(Path folder, long firstNumber, PictureWriter pictures) {
        this.folder = folder;
        this.nextNumber = firstNumber;
        this.pictures = pictures;
    }

    /**
     * Starts recording into a folder, to frame-000001.png and so on, after the highest existing number.
     *
     * @throws IOException if the folder cannot be read or written
     */
    public static FrameRecorder start(Path folder) throws IOException {
        return start(folder, PngWriter::write);
    }

    static FrameRecorder start(Path folder, PictureWriter pictures) throws IOException {
        if (!Files.isDirectory(folder)) {
            throw new IOException("cannot record into " + folder + ": there is no such folder");
        }
        if (!Files.isWritable(folder)) {
            throw new IOException("cannot record into " + folder + ": no permission to write there");
        }
        return new FrameRecorder(folder, firstFreeNumber(folder), pictures);
    }

    /**
     * Records a copy of a frame; waits while too many frames are waiting. Called by one thread at a time.
     *
     * @param argb {@code width * height} ints from index 0 on, 0xAARRGGBB, row by row from the top
     * @param srgb whether they are sRGB-encoded
     * @return whether it will be written; false after the end, or after a failure
     */
    public boolean offer(int width, int height, IntBuffer argb, boolean srgb) {
        try {
            submit(width, height, argb, srgb);
            return true;
        } catch (IOException | RuntimeException | Error _) {
            // Told by the progress.
            return false;
        }
    }

    private void submit(int width, int height, IntBuffer argb, boolean srgb) throws IOException {
        int[] copy = copy(width, height, argb);
        Path file = folder.resolve(String.format(Locale.ROOT, "frame-%06d.png", nextNumber));
        writer.submit((long) Integer.BYTES * copy.length, () -> pictures.write(file, width, height, copy, srgb));
        nextNumber++;
    }

    private int[] copy(int width, int height, IntBuffer argb) throws IOException {
        try {
            int[] copy = new int[Math.multiplyExact(width, height)];
            argb.get(0, copy);
            return copy;
        } catch (RuntimeException | Error problem) {
            // Ends the recording after the frames before this one.
            writer.submit(0, () -> {
                throw problem;
            });
            throw problem;
        }
    }

    public Progress progress() {
        return new Progress(writer.written(), writer.waiting(), writer.failure().map(FrameRecorder::explain));
    }

    public Path folder() {
        return folder;
    }

    /** Accepts no more frames; those that wait are still written. Returns at once. */
    public void finish() {
        writer.end();
    }

    /** Waits until every accepted frame is written. */
    @Override
    public void close() {
        writer.close();
    }

    private static String explain(Throwable problem) {
        return "Recording has stopped: "
                + switch (problem) {
                    case IOException told -> told.getMessage();
                    case OutOfMemoryError _ -> "there is not enough memory for its frames";
                    default -> problem.toString();
                };
    }

    private static long firstFreeNumber(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return 1
                    + files.map(file -> NUMBERED.matcher(file.getFileName().toString()))
                            .filter(Matcher::matches)
                            .mapToLong(name -> Long.parseLong(name.group(1)))
                            .max()
                            .orElse(0);
        }
    }
}
