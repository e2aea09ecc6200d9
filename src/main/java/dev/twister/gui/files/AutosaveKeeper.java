package dev.twister.gui.files;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Dialogs.Answer;
import dev.twister.gui.edit.SceneHistory;
import dev.twister.gui.files.AutosaveFolder.Autosave;
import dev.twister.gui.studio.EditedFile;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.SceneException;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import javafx.application.Platform;

/**
 * Autosaves edits, so that a killed process does not lose them, and offers to restore those of killed processes. Used
 * by JavaFX's thread; files are written on another.
 */
public final class AutosaveKeeper implements AutoCloseable {
    /** It looks for edits this many times in the delay. */
    private static final int LOOKS = 6;

    /** Writing takes at most one part in this many of the time, so that large scenes are written less often. */
    private static final int REST = 10;

    private final Studio studio;
    private final AutosaveFolder folder;
    private final ExecutorService thread = Executors.newSingleThreadExecutor(
            Thread.ofPlatform().daemon().name("autosave").factory());
    private Optional<SceneHistory.Version> kept = Optional.empty();
    private Optional<Long> waitingSince = Optional.empty();
    private boolean writing;
    private long writeNanos;
    private long lookedNanos;
    private String complaint = "";

    /** Used only by the writing thread. */
    private Optional<Autosave> current = Optional.empty();

    public AutosaveKeeper(Studio studio, AutosaveFolder folder) {
        this.studio = studio;
        this.folder = folder;
    }

    /** Offers to restore the edits of killed processes, one scene after the other. */
    public void offer(Dialogs dialogs, FileActions files) {
        thread.execute(() -> {
            List<Autosave> found = folder.leftBehind();
            Platform.runLater(() -> offer(found, dialogs, files));
        });
    }

    private void offer(List<Autosave> found, Dialogs dialogs, FileActions files) {
        if (found.isEmpty()) {
            return;
        }
        Autosave newest = found.getFirst();
        List<Autosave> others = found.subList(1, found.size());
        dialogs.askToRestore(
                FileNames.name(newest.edited().path()),
                newest.written(),
                new Answer("Restore", () -> {
                    leave(others);
                    files.restore(newest, () -> adopt(newest), () -> leave(List.of(newest)));
                }),
                new Answer("Discard", () -> {
                    thread.execute(() -> delete(newest));
                    offer(others, dialogs, files);
                }),
                new Answer("Later", () -> leave(found)));
    }

    /** Called in every pulse. */
    public void pulse(long nanos) {
        if (folder.folder().isEmpty() || LOOKS * (nanos - lookedNanos) < delayNanos()) {
            return;
        }
        lookedNanos = nanos;
        if (!studio.document().editsProperty().get().changed()) {
            waitingSince = Optional.empty();
            kept.ifPresent(_ -> thread.execute(this::forget));
            kept = Optional.empty();
            return;
        }
        SceneHistory.Version now = studio.document().present();
        if (writing || kept.filter(now::isSame).isPresent()) {
            return;
        }
        if (waitingSince.isEmpty()) {
            waitingSince = Optional.of(nanos);
        } else if (nanos - waitingSince.get() >= Math.max(delayNanos(), REST * writeNanos)) {
            waitingSince = Optional.empty();
            writing = true;
            kept = Optional.of(now);
            EditedFile file = studio.document().fileProperty().get();
            thread.execute(() -> write(now, file));
        }
    }

    private long delayNanos() {
        return folder.delay().toNanos();
    }

    private void write(SceneHistory.Version version, EditedFile file) {
        long began = System.nanoTime();
        String problem = "";
        try {
            Optional<Autosave> old =
                    current.filter(autosave -> !autosave.edited().equals(file));
            if (current.isEmpty() || old.isPresent()) {
                current = Optional.of(folder.begin(file));
            }
            current.orElseThrow().write(version.scene());
            old.ifPresent(AutosaveKeeper::delete);
        } catch (IOException | SceneException refused) {
            problem = Dialogs.explain(refused);
        }
        long took = System.nanoTime() - began;
        String said = problem;
        Platform.runLater(() -> wrote(said, took));
    }

    private void wrote(String problem, long nanos) {
        writing = false;
        writeNanos = nanos;
        if (!problem.isEmpty()) {
            kept = Optional.empty();
            if (!problem.equals(complaint)) {
                studio.notice("Unsaved changes are not autosaved: " + problem);
            }
        }
        complaint = problem;
    }

    /** Marks found edits as those that the studio has now. */
    private void adopt(Autosave restored) {
        kept = Optional.of(studio.document().present());
        thread.execute(() -> {
            forget();
            current = Optional.of(restored);
        });
    }

    private void leave(List<Autosave> found) {
        thread.execute(() -> found.forEach(autosave -> {
            try (autosave) {
                // Closing it leaves it to other processes.
            } catch (IOException _) {
                // The lock ends with the process.
            }
        }));
    }

    private void forget() {
        current.ifPresent(AutosaveKeeper::delete);
        current = Optional.empty();
    }

    private static void delete(Autosave autosave) {
        try {
            autosave.delete();
        } catch (IOException _) {
            // It will be offered again at the next start.
        }
    }

    /** Deletes the autosaved file after the present tasks. Returns at once. */
    public void finish() {
        thread.execute(this::forget);
        thread.shutdown();
    }

    /** Waits for the thread to end; called after {@link #finish}, by any thread. */
    @Override
    public void close() {
        thread.close();
    }
}
