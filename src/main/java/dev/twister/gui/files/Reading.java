package dev.twister.gui.files;

import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** Reads one file at a time in the background; reading another one cancels it. Used by JavaFX's thread. */
public final class Reading {
    private final ReadOnlyObjectWrapper<Optional<Task>> present = new ReadOnlyObjectWrapper<>(Optional.empty());

    /**
     * A file that is being read.
     *
     * @param name of the file, for the status line
     * @param canceled called if it is canceled
     */
    record Task(String name, Thread thread, Runnable canceled) {}

    /** The file that is being read. */
    ReadOnlyObjectProperty<Optional<Task>> presentProperty() {
        return present.getReadOnlyProperty();
    }

    /**
     * Cancels the present file and reads another. Calls exactly one of the three, on JavaFX's thread.
     *
     * @param done gets the result
     * @param failed gets what was thrown
     * @param canceled called if it is canceled first
     */
    <T> void begin(String name, Callable<T> read, Consumer<T> done, Consumer<Throwable> failed, Runnable canceled) {
        cancel();
        Thread thread = Thread.ofPlatform().daemon().name("reading").unstarted(() -> {
            try {
                T result = read.call();
                end(Thread.currentThread(), () -> done.accept(result));
            } catch (Exception | Error problem) {
                // Errors too: a file may be too large for the memory.
                end(Thread.currentThread(), () -> failed.accept(problem));
            }
        });
        present.set(Optional.of(new Task(name, thread, canceled)));
        thread.start();
    }

    private void end(Thread thread, Runnable then) {
        Platform.runLater(() -> {
            if (present.get().filter(task -> task.thread().equals(thread)).isPresent()) {
                present.set(Optional.empty());
                then.run();
            }
        });
    }

    /** Cancels reading. */
    public void cancel() {
        present.get().ifPresent(task -> {
            present.set(Optional.empty());
            // This closes the file under the reading thread.
            task.thread().interrupt();
            task.canceled().run();
        });
    }
}
