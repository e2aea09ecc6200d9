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
 * Works beside JavaFX's thread, and tells it how it went: scenes are written on one thread, pictures on another, and
 * what need not be kept is done on a third, each one after the other. Used by JavaFX's thread, but for its end.
 */
public final class Errands implements AutoCloseable {
    private final ExecutorService passing = thread("errands");
    private final ExecutorService scenes = thread("scenes");
    private final ExecutorService pictures = thread("pictures");

    /** Each done as soon as an errand that is to be kept is with its thread. */
    private final Collection<CompletableFuture<?>> handedOver = new ConcurrentLinkedQueue<>();

    private volatile boolean closed;

    private static ExecutorService thread(String name) {
        return Executors.newSingleThreadExecutor(
                Thread.ofPlatform().daemon().name(name).factory());
    }

    /**
     * Does that, but not where the window is closed before it is begun; after that it does nothing.
     *
     * @param done gets the result, on JavaFX's thread
     * @param failed gets whatever was thrown, on JavaFX's thread
     */
    public <T> void run(Callable<T> errand, Consumer<T> done, Consumer<Throwable> failed) {
        if (!closed) {
            passing.execute(() -> {
                if (!closed) {
                    doNow(errand, done, failed);
                }
            });
        }
    }

    /** Writes a scene, which a person wants to keep: the window is not closed before, and nothing else delays it. */
    public <T> void keepScene(Callable<T> errand, Consumer<T> done, Consumer<Throwable> failed) {
        scenes.execute(() -> doNow(errand, done, failed));
    }

    /** The same for a picture, begun when what it needs is there or has failed; until then it holds up no other one. */
    public <T> void keepPicture(
            CompletableFuture<?> needed, Callable<T> errand, Consumer<T> done, Consumer<Throwable> failed) {
        handedOver.removeIf(CompletableFuture::isDone);
        handedOver.add(needed.handle((_, _) -> {
            pictures.execute(() -> doNow(errand, done, failed));
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
    public void finish() {
        closed = true;
    }

    /** Waits for what is to be kept; called by any thread. */
    @Override
    public void close() {
        finish();
        passing.shutdown();
        scenes.close();
        handedOver.forEach(CompletableFuture::join);
        pictures.close();
    }
}
