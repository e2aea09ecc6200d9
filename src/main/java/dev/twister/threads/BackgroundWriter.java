package dev.twister.threads;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * Writes files on background threads, so that the caller can prepare the next one. What waits is bounded: a caller that
 * is faster than the disk waits. After a failure nothing more is written.
 */
public final class BackgroundWriter implements AutoCloseable {
    /** One piece of work, usually one file or one frame. */
    @FunctionalInterface
    public interface Work {
        void run() throws IOException;
    }

    private final ExecutorService threads;
    private final long room;
    private long usedRoom;
    private int waiting;
    private long written;
    private boolean ended;
    private Optional<Throwable> failure = Optional.empty();

    /**
     * Starts without work.
     *
     * @param threads 1 if the work must be done in the order in which it comes
     * @param room limit of the total size of all work that is not done yet, in the caller's unit
     */
    public BackgroundWriter(String name, int threads, long room) {
        this.threads = Executors.newFixedThreadPool(
                threads, Thread.ofPlatform().name(name + " ", 0).daemon().factory());
        this.room = room;
    }

    /**
     * Queues work. Waits while there is no room for it; work that is larger than the whole room waits until it is
     * alone.
     *
     * @throws IOException the failure of earlier work, or if {@link #end} was called or the thread is interrupted
     */
    public synchronized void submit(long size, Work work) throws IOException {
        await(() -> ended || failure.isPresent() || waiting == 0 || usedRoom + size <= room);
        check();
        if (ended) {
            throw new IOException("the writer has ended");
        }
        usedRoom += size;
        waiting++;
        threads.execute(() -> run(size, work));
    }

    private void run(long size, Work work) {
        Optional<Throwable> problem = failure();
        try {
            if (problem.isEmpty()) {
                work.run();
            }
        } catch (IOException | RuntimeException | Error thrown) {
            problem = Optional.of(thrown);
        }
        done(size, problem);
    }

    private synchronized void done(long size, Optional<Throwable> problem) {
        usedRoom -= size;
        waiting--;
        if (problem.isEmpty()) {
            written++;
        } else if (failure.isEmpty()) {
            failure = problem;
        }
        notifyAll();
    }

    /** Number of pieces that are done. */
    public synchronized long written() {
        return written;
    }

    /** Number of pieces that are not done yet. */
    public synchronized int waiting() {
        return waiting;
    }

    /** The first failure. */
    public synchronized Optional<Throwable> failure() {
        return failure;
    }

    /** Accepts no more work; returns at once. Work that waits is still done. */
    public synchronized void end() {
        ended = true;
        notifyAll();
    }

    /**
     * Waits until all work is done.
     *
     * @throws IOException the first failure, or if the thread is interrupted
     */
    public synchronized void finish() throws IOException {
        await(() -> waiting == 0);
        check();
    }

    private void check() throws IOException {
        if (failure.isPresent()) {
            switch (failure.get()) {
                case IOException thrown -> throw thrown;
                case RuntimeException thrown -> throw thrown;
                case Error thrown -> throw thrown;
                default -> throw new AssertionError(failure.get());
            }
        }
    }

    private void await(BooleanSupplier condition) throws IOException {
        while (!condition.getAsBoolean()) {
            try {
                wait();
            } catch (InterruptedException _) {
                Thread.currentThread().interrupt();
                throw new InterruptedIOException("interrupted");
            }
        }
    }

    /** Ends, and waits until all work is done or, after a failure, dropped. */
    @Override
    public void close() {
        end();
        threads.shutdown();
        boolean interrupted = false;
        boolean terminated = false;
        while (!terminated) {
            try {
                terminated = threads.awaitTermination(1, TimeUnit.DAYS);
            } catch (InterruptedException _) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
