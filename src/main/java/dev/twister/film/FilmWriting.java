package dev.twister.film;

import java.io.IOException;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;

/** Encodes a film on another thread while its next frames are drawn; a bounded number of them waits. */
public final class FilmWriting implements AutoCloseable {
    /** How many pictures are kept beside the one that is drawn: those that wait and the one that is encoded. */
    public static final int WAITING = 3;

    private static final int[] GIVEN_UP = {};
    private static final long POLL_MILLIS = 100;

    private final BlockingQueue<int[]> frames = new ArrayBlockingQueue<>(WAITING - 1);
    private final FutureTask<Void> encoding;
    private boolean finished;

    /** Begins a film; {@link #close} is to be called. */
    public FilmWriting(FilmFile film, FilmFormat format) {
        encoding = new FutureTask<>(() -> {
            film.write(format, this::next);
            return null;
        });
        Thread.ofPlatform().name("encoding").daemon().start(encoding);
    }

    private int[] next() throws IOException {
        try {
            int[] frame = frames.take();
            if (frame.length == 0) {
                throw new IOException("the film was given up");
            }
            return frame;
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", interrupted);
        }
    }

    /**
     * Takes the next frame; waits while too many are waiting.
     *
     * @throws IOException what the encoder has thrown
     */
    public void add(int[] srgb) throws IOException {
        boolean taken = false;
        while (!taken) {
            if (encoding.isDone()) {
                result();
                throw new IOException("the encoder ended before the film's last frame");
            }
            taken = offer(srgb);
        }
    }

    private boolean offer(int[] frame) throws IOException {
        try {
            return frames.offer(frame, POLL_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", interrupted);
        }
    }

    /**
     * Waits until the film is written.
     *
     * @throws IOException what the encoder has thrown
     */
    public void finish() throws IOException {
        finished = true;
        result();
    }

    private void result() throws IOException {
        try {
            encoding.get();
        } catch (ExecutionException failure) {
            switch (failure.getCause()) {
                case IOException written -> throw written;
                case Error error -> throw error;
                default -> throw new IllegalStateException(failure.getCause());
            }
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", interrupted);
        }
    }

    /** Gives the film up, where it is not finished: no file is left. */
    @Override
    public void close() throws IOException {
        while (!finished && !encoding.isDone()) {
            finished = offer(GIVEN_UP);
        }
        try {
            encoding.get();
        } catch (ExecutionException | InterruptedException _) {
            // Told already, or given up for another reason.
        }
    }
}
