package dev.twister.gui.studio;

import java.util.Collection;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import javafx.application.Platform;

/**
 * Runs tasks in the background and reports to JavaFX's thread: one thread writes scenes, one writes pictures, one does
 * the rest. Used by JavaFX's thread, except for {@link #close}.
 */
public final class BackgroundTasks implements AutoCloseable {
    private final ExecutorService passing = thread("background tasks");
    private final ExecutorService files = thread("files");
    private final ExecutorService pictures = thread("pictures");

    /** Each completes when its picture task has been passed to the thread. */
    private final Collection<CompletableFuture<?>> handedOver = new ConcurrentLinkedQueue<>();

    private volatile boolean closed;

    private static ExecutorService thread(String name) {
        return Executors.newSingleThreadExecutor(
                Thread.ofPlatform().daemon().name(name).factory());
    }

    /**
     * Runs a task, unless the window is closed first.
     *
     * @param done gets the result, on JavaFX's thread
     * @param failed gets what was thrown, on JavaFX's thread
     */
    public <T> void run(Callable<T> task, Consumer<T> done, Consumer<Throwable> failed) {
        if (!closed) {
            passing.execute(() -> {
                if (!closed) {
                    doNow(task, done, failed);
                }
            });
        }
    }

    /**
     * Runs a task that writes a scene or the settings: closing the window waits for it, and other tasks do not delay
     * it.
     */
    public <T> void keepFile(Callable<T> task, Consumer<T> done, Consumer<Throwable> failed) {
        files.execute(() -> doNow(task, done, failed));
    }

    /** Runs a task that writes a picture once what it needs is complete; closing the window waits for it. */
    public <T> void keepPicture(
            CompletableFuture<?> needed, Callable<T> task, Consumer<T> done, Consumer<Throwable> failed) {
        handedOver.removeIf(CompletableFuture::isDone);
        handedOver.add(needed.handle((_, _) -> {
            pictures.execute(() -> doNow(task, done, failed));
            return "";
        }));
    }

    private static <T> void doNow(Callable<T> task, Consumer<T> done, Consumer<Throwable> failed) {
        try {
            T result = task.call();
            Platform.runLater(() -> done.accept(result));
        } catch (Exception | Error problem) {
            // Errors too: a file may be too large for the memory.
            Platform.runLater(() -> failed.accept(problem));
        }
    }

    /** Starts no more tasks except those that write. Returns at once. */
    public void finish() {
        closed = true;
    }

    /** Waits for the tasks that write; called by any thread. */
    @Override
    public void close() {
        finish();
        passing.shutdown();
        files.close();
        handedOver.forEach(CompletableFuture::join);
        pictures.close();
    }
}
