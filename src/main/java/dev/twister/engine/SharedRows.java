package dev.twister.engine;

import dev.twister.image.FrameStop;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;
import java.util.function.Supplier;

/**
 * Rows that the calling thread and those of the common pool render together. An interrupt of the caller is seen by all
 * of them, which a parallel stream hides while its caller waits.
 */
final class SharedRows {
    private final int count;
    private final Supplier<IntConsumer> renderers;
    private final AtomicInteger next = new AtomicInteger();
    private int active;
    private boolean over;
    private Throwable failure;

    private SharedRows(int count, Supplier<IntConsumer> renderers) {
        this.count = count;
        this.renderers = renderers;
    }

    /**
     * Renders all rows.
     *
     * @param renderers gives each thread its own
     * @param stop asked to stop if the caller is interrupted while it waits for the others
     */
    static void forEach(int count, Supplier<IntConsumer> renderers, FrameStop stop) {
        SharedRows rows = new SharedRows(count, renderers);
        ForkJoinPool pool = ForkJoinPool.commonPool();
        for (int helper = 0; helper < Math.min(pool.getParallelism(), count - 1); helper++) {
            pool.execute(rows::help);
        }
        try {
            rows.take();
        } finally {
            rows.awaitHelpers(stop);
        }
        rows.rethrow();
    }

    private void take() {
        IntConsumer renderer = renderers.get();
        for (int row = next.getAndIncrement(); row < count; row = next.getAndIncrement()) {
            renderer.accept(row);
        }
    }

    /** A helper that the pool starts too late does nothing. */
    private void help() {
        if (enter()) {
            try {
                take();
            } catch (RuntimeException | Error problem) {
                fail(problem);
            } finally {
                leave();
            }
        }
    }

    private synchronized boolean enter() {
        active += over ? 0 : 1;
        return !over;
    }

    private synchronized void leave() {
        active--;
        notifyAll();
    }

    private synchronized void fail(Throwable problem) {
        failure = problem;
        next.set(count);
    }

    private synchronized void awaitHelpers(FrameStop stop) {
        over = true;
        boolean interrupted = false;
        while (active > 0) {
            try {
                wait();
            } catch (InterruptedException _) {
                interrupted = true;
                stop.ask();
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized void rethrow() {
        switch (failure) {
            case RuntimeException problem -> throw problem;
            case Error problem -> throw problem;
            case null, default -> {}
        }
    }
}
