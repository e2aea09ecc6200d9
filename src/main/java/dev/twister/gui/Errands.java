package dev.twister.gui;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import javafx.application.Platform;

/** Reads and writes files on a thread of its own, one after the other, and tells JavaFX's thread how it went. */
final class Errands implements AutoCloseable {
    private final ExecutorService thread = Executors.newSingleThreadExecutor(
            Thread.ofPlatform().daemon().name("errands").factory());

    /**
     * Does that.
     *
     * @param done gets the result, on JavaFX's thread
     * @param failed gets whatever was thrown, on JavaFX's thread
     */
    <T> void run(Callable<T> errand, Consumer<T> done, Consumer<Throwable> failed) {
        thread.execute(() -> {
            try {
                T result = errand.call();
                Platform.runLater(() -> done.accept(result));
            } catch (Exception | Error problem) {
                // A file too large for the memory, for one, is that file's failure and not the window's.
                Platform.runLater(() -> failed.accept(problem));
            }
        });
    }

    /** Begins no further errand; one that is at work is finished. */
    @Override
    public void close() {
        thread.shutdown();
    }
}
