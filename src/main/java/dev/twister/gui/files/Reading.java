package dev.twister.gui.files;

import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/**
 * Reads one file at a time beside JavaFX's thread, as long as a person wants it: whatever is read next takes its place.
 * Used by JavaFX's thread.
 */
public final class Reading {
    private final ReadOnlyObjectWrapper<Optional<Task>> present = new ReadOnlyObjectWrapper<>(Optional.empty());

    /**
     * A file that is being read.
     *
     * @param name of the file, for a person
     * @param canceled called where nobody wants it any more
     */
    record Task(String name, Thread thread, Runnable canceled) {}

    /** What is being read. */
    ReadOnlyObjectProperty<Optional<Task>> presentProperty() {
        return present.getReadOnlyProperty();
    }

    /**
     * Reads a file, and no other one any more. Either one of the three is called, on JavaFX's thread.
     *
     * @param done gets what was read
     * @param failed gets whatever was thrown
     * @param canceled called where another one is read, or none any more, before that
     */
    <T> void begin(String name, Callable<T> read, Consumer<T> done, Consumer<Throwable> failed, Runnable canceled) {
        cancel();
        Thread thread = Thread.ofPlatform().daemon().name("reading").unstarted(() -> {
            try {
                T result = read.call();
                end(Thread.currentThread(), () -> done.accept(result));
            } catch (Exception | Error problem) {
                // A file too large for the memory, for one, is that file's failure and not the window's.
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

    /** What is being read is not wanted any more. */
    public void cancel() {
        present.get().ifPresent(task -> {
            present.set(Optional.empty());
            // Which closes the file under the thread that reads it.
            task.thread().interrupt();
            task.canceled().run();
        });
    }
}
