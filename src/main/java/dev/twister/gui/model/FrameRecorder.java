package dev.twister.gui.model;

import dev.twister.image.PngWriter;
import java.io.IOException;
import java.nio.IntBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Writes frames as numbered PNG files, on a thread of its own. No frame is left out: where the disk or the encoder is
 * slower than the frames come, the caller that hands them over waits once a few are ahead.
 */
public final class FrameRecorder implements AutoCloseable {
    private static final Pattern NUMBERED = Pattern.compile("frame-([0-9]{6,9})\\.png");

    /** Frames of 4K are 33 MB each. */
    private static final long MAX_WAITING_BYTES = 256L << 20;

    /** What a file is written with; a test has slower ones. */
    @FunctionalInterface
    interface PictureWriter {
        void write(Path file, int width, int height, int[] argb, boolean srgb) throws IOException;
    }

    /**
     * How it goes.
     *
     * @param written frames on the disk
     * @param waiting frames that are still to be written
     * @param lost frames that were taken but not written, because of the failure
     * @param failure why nothing is written any more; empty while all is well
     */
    public record Progress(long written, int waiting, long lost, Optional<String> failure) {}

    @SuppressWarnings("ArrayRecordComponent") // handed on, never compared
    private record Waiting(int width, int height, int[] argb, boolean srgb) {
        long bytes() {
            return (long) Integer.BYTES * argb.length;
        }
    }

    private final Path folder;
    private final PictureWriter writer;
    private final Thread thread;
    private final Deque<Waiting> queue = new ArrayDeque<>();
    private final Deque<int[]> spare = new ArrayDeque<>();
    private long waitingBytes;
    private int inWork;
    private int beingCopied;
    private long nextNumber;
    private long written;
    private long lost;
    private boolean closing;
    private Optional<String> failure = Optional.empty();

    private FrameRecorder(Path folder, long firstNumber, PictureWriter writer) {
        this.folder = folder;
        this.nextNumber = firstNumber;
        this.writer = writer;
        thread = Thread.ofPlatform().name("twister-recorder").daemon(true).unstarted(this::writeFrames);
    }

    /**
     * Starts to record into a folder: frame-000001.png and so on, after the highest number that is there.
     *
     * @throws IOException where the folder cannot be read or written in
     */
    public static FrameRecorder start(Path folder) throws IOException {
        return start(folder, PngWriter::write);
    }

    static FrameRecorder start(Path folder, PictureWriter writer) throws IOException {
        if (!Files.isDirectory(folder)) {
            throw new IOException("cannot record into " + folder + ": there is no such folder");
        }
        if (!Files.isWritable(folder)) {
            throw new IOException("cannot record into " + folder + ": no permission to write there");
        }
        FrameRecorder recorder = new FrameRecorder(folder, firstFreeNumber(folder), writer);
        recorder.thread.start();
        return recorder;
    }

    /**
     * Takes a copy of a frame; waits for room where too many are ahead of it. Called by one thread at a time.
     *
     * @param argb {@code width * height} ints from index 0 on, 0xAARRGGBB, row by row from the top
     * @param srgb whether they are sRGB-encoded
     * @return whether it was taken: not after the end
     */
    public boolean offer(int width, int height, IntBuffer argb, boolean srgb) {
        int pixels = Math.multiplyExact(width, height);
        Optional<int[]> used;
        synchronized (this) {
            long bytes = (long) Integer.BYTES * pixels;
            // However large a frame is, one may wait.
            if (awaitThat(() -> isOver() || waitingBytes == 0 || waitingBytes + bytes <= MAX_WAITING_BYTES)) {
                Thread.currentThread().interrupt();
            }
            if (isOver()) {
                return false;
            }
            waitingBytes += bytes;
            beingCopied++;
            used = Optional.ofNullable(spare.poll()).filter(buffer -> buffer.length == pixels);
        }
        try {
            int[] copy = used.orElseGet(() -> new int[pixels]);
            argb.get(0, copy, 0, pixels);
            return add(new Waiting(width, height, copy, srgb));
        } catch (RuntimeException | Error problem) {
            copyingFailed(problem);
            return false;
        }
    }

    private synchronized boolean add(Waiting frame) {
        beingCopied--;
        boolean taken = failure.isEmpty();
        if (taken) {
            queue.add(frame);
        } else {
            lost++;
        }
        notifyAll();
        return taken;
    }

    /** Those that were taken before are still written. */
    private synchronized void copyingFailed(Throwable problem) {
        beingCopied--;
        lost++;
        stop(problem);
    }

    public synchronized Progress progress() {
        return new Progress(written, beingCopied + queue.size() + inWork, lost, failure);
    }

    public Path folder() {
        return folder;
    }

    /** Takes no more frames; those that wait are still written. Returns at once. */
    public synchronized void finish() {
        closing = true;
        notifyAll();
    }

    /** Waits until every frame that was taken is written. */
    @Override
    public void close() {
        finish();
        boolean interrupted = false;
        while (thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException _) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void writeFrames() {
        Optional<Waiting> frame = take();
        while (frame.isPresent()) {
            Waiting taken = frame.get();
            try {
                writer.write(
                        folder.resolve(String.format(Locale.ROOT, "frame-%06d.png", nextNumber)),
                        taken.width(),
                        taken.height(),
                        taken.argb(),
                        taken.srgb());
                done(taken);
                frame = take();
            } catch (IOException | RuntimeException | Error problem) {
                writingFailed(problem);
                frame = Optional.empty();
            }
        }
    }

    private synchronized Optional<Waiting> take() {
        // Nobody interrupts a thread that is known here alone.
        awaitThat(() -> !queue.isEmpty() || (isOver() && beingCopied == 0));
        Optional<Waiting> next = Optional.ofNullable(queue.poll());
        inWork = next.isPresent() ? 1 : 0;
        return next;
    }

    private synchronized void done(Waiting frame) {
        written++;
        nextNumber++;
        inWork = 0;
        waitingBytes -= frame.bytes();
        // A frame of another size has no use for the buffers of this one.
        spare.clear();
        spare.push(frame.argb());
        notifyAll();
    }

    private boolean isOver() {
        return closing || failure.isPresent();
    }

    /** An interruption ends the recording; whether there was one. */
    private synchronized boolean awaitThat(BooleanSupplier condition) {
        boolean interrupted = false;
        while (!condition.getAsBoolean()) {
            try {
                wait();
            } catch (InterruptedException _) {
                interrupted = true;
                closing = true;
            }
        }
        return interrupted;
    }

    private synchronized void writingFailed(Throwable problem) {
        lost += queue.size() + inWork;
        queue.clear();
        inWork = 0;
        stop(problem);
    }

    private synchronized void stop(Throwable problem) {
        failure = Optional.of("Recording has stopped: " + explain(problem));
        notifyAll();
    }

    private static String explain(Throwable problem) {
        return switch (problem) {
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
