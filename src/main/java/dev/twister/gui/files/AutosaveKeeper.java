package dev.twister.gui.files;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Dialogs.Answer;
import dev.twister.gui.controls.Problems;
import dev.twister.gui.model.Autosave;
import dev.twister.gui.model.AutosaveFolder;
import dev.twister.gui.model.EditedFile;
import dev.twister.gui.model.SceneHistory;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.SceneException;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import javafx.application.Platform;

/**
 * Keeps unsaved edits until they are saved or given up, so that a process that is killed does not lose them, and offers
 * those that one has left. Used by JavaFX's thread; files are written on a thread of its own.
 */
public final class AutosaveKeeper implements AutoCloseable {
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

    /** From an edit to its writing; what is edited meanwhile is written with it. */
    private static final long DELAY_NANOS = TimeUnit.SECONDS.toNanos(3);

    /** Large scenes are written less often: the share of the time that goes into it stays below a tenth. */
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

    /** Used by the own thread alone. */
    private Optional<Autosave> current = Optional.empty();

    public AutosaveKeeper(Studio studio, AutosaveFolder folder) {
        this.studio = studio;
        this.folder = folder;
    }

    /** Asks what is to become of edits that killed processes have left, one scene after the other. */
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
        if (folder.folder().isEmpty() || nanos - lookedNanos < LOOK_NANOS) {
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
        } else if (nanos - waitingSince.get() >= Math.max(DELAY_NANOS, REST * writeNanos)) {
            waitingSince = Optional.empty();
            writing = true;
            kept = Optional.of(now);
            EditedFile file = studio.document().fileProperty().get();
            thread.execute(() -> write(now, file));
        }
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
            problem = Problems.explain(refused);
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

    /** The edits that were found are the ones that the studio has now. */
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
                // Others may have it.
            } catch (IOException _) {
                // It ends with the process.
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
            // It is offered once more than it should be.
        }
    }

    /** Nothing is unsaved any more. Returns at once. */
    public void finish() {
        thread.execute(this::forget);
        thread.shutdown();
    }

    /** Waits for the last file; called after {@link #finish}, by any thread. */
    @Override
    public void close() {
        thread.close();
    }
}
