package dev.twister.render;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;

/** Writes files on other threads while the next pictures are drawn; a bounded number of them waits. */
public final class WritingBeside implements AutoCloseable {
    /** Work that may fail. */
    @FunctionalInterface
    interface Work {
        void run() throws IOException;
    }

    private final ExecutorService writers;
    private final Semaphore places;
    private final int most;
    private final AtomicReference<Optional<Throwable>> failure = new AtomicReference<>(Optional.empty());

    /**
     * Begins with nothing to do.
     *
     * @param threads 1 where files must be written in the order in which they come
     */
    WritingBeside(int threads) {
        writers = Executors.newFixedThreadPool(
                threads, Thread.ofPlatform().name("writing ", 0).daemon().factory());
        most = waiting(threads);
        places = new Semaphore(most);
    }

    /** How many pictures are kept beside the one that is drawn. */
    static int waiting(int threads) {
        return threads + 1;
    }

    /**
     * Lets something be done as soon as a thread has time; waits while too much is waiting.
     *
     * @throws IOException what work before this has thrown
     */
    void submit(Work work) throws IOException {
        places.acquireUninterruptibly();
        check();
        writers.execute(() -> {
            try {
                if (failure.get().isEmpty()) {
                    work.run();
                }
            } catch (IOException | RuntimeException | Error problem) {
                failure.compareAndSet(Optional.empty(), Optional.of(problem));
            } finally {
                places.release();
            }
        });
    }

    private void check() throws IOException {
        Optional<Throwable> problem = failure.get();
        if (problem.isPresent()) {
            switch (problem.get()) {
                case IOException written -> throw written;
                case Error error -> throw error;
                default -> throw new IllegalStateException(problem.get());
            }
        }
    }

    /**
     * Waits until everything is done.
     *
     * @throws IOException what any work has thrown
     */
    void finish() throws IOException {
        places.acquireUninterruptibly(most);
        places.release(most);
        check();
    }

    @Override
    public void close() {
        writers.shutdown();
        boolean interrupted = false;
        boolean ended = false;
        while (!ended) {
            try {
                ended = writers.awaitTermination(1, TimeUnit.DAYS);
            } catch (InterruptedException _) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
