package dev.twister.gui;

import java.util.Collection;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import javafx.application.Platform;

/**
 * Reads and writes files on a thread of its own, one after the other, and tells JavaFX's thread how it went. Used by that
 * thread, but for its end.
 */
final class Errands implements AutoCloseable {
    private final ExecutorService thread = Executors.newSingleThreadExecutor(
            Thread.ofPlatform().daemon().name("errands").factory());
    private final AtomicInteger toKeep = new AtomicInteger();

    /** Each done as soon as an errand that is to be kept is with the thread. */
    private final Collection<CompletableFuture<?>> handedOver = new ConcurrentLinkedQueue<>();

    private volatile boolean closed;

    /**
     * Does that, but not where the window is closed before it is begun; after that it does nothing.
     *
     * @param done gets the result, on JavaFX's thread
     * @param failed gets whatever was thrown, on JavaFX's thread
     */
    <T> void run(Callable<T> errand, Consumer<T> done, Consumer<Throwable> failed) {
        if (!closed) {
            thread.execute(() -> {
                if (!closed) {
                    doNow(errand, done, failed);
                }
            });
        }
    }

    /** Does what a person wants to keep: the window is not closed before. */
    <T> void keep(Callable<T> errand, Consumer<T> done, Consumer<Throwable> failed) {
        keepAfter(CompletableFuture.completedFuture(""), errand, done, failed);
    }

    /** The same, begun when what it needs is there or has failed; until then it holds up no other errand. */
    <T> void keepAfter(CompletableFuture<?> needed, Callable<T> errand, Consumer<T> done, Consumer<Throwable> failed) {
        toKeep.incrementAndGet();
        handedOver.removeIf(CompletableFuture::isDone);
        handedOver.add(needed.handle((_, _) -> {
            thread.execute(() -> {
                try {
                    doNow(errand, done, failed);
                } finally {
                    toKeep.decrementAndGet();
                }
            });
            return "";
        }));
    }

    private static <T> void doNow(Callable<T> errand, Consumer<T> done, Consumer<Throwable> failed) {
        try {
            T result = errand.call();
            Platform.runLater(() -> done.accept(result));
        } catch (Exception | Error problem) {
            // A file too large for the memory, for one, is that file's failure and not the window's.
            Platform.runLater(() -> failed.accept(problem));
        }
    }

    /** From now on only what is to be kept is begun. Returns at once. */
    void finish() {
        closed = true;
    }

    /** Waits for what is to be kept; called by any thread. */
    @Override
    public void close() {
        finish();
        handedOver.forEach(CompletableFuture::join);
        thread.shutdown();
        if (toKeep.get() > 0) {
            thread.close();
        }
    }
}
