package dev.twister.gui.files;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Dialogs.Answer;
import dev.twister.gui.controls.Problems;
import dev.twister.gui.model.CopiedTitle;
import dev.twister.gui.model.DaylightFile;
import dev.twister.gui.model.EditedFile;
import dev.twister.gui.model.FileMark;
import dev.twister.gui.model.SceneHistory;
import dev.twister.gui.studio.Document;
import dev.twister.gui.studio.Errands;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.format.SceneWriter;
import dev.twister.scene.select.Title;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** Saves the scene, and asks before unsaved changes are lost or another program's are overwritten. */
public final class SceneSaving {
    private final Studio studio;
    private final Document document;
    private final FileChoice choice;
    private final ShippedFolders shipped;
    private final Dialogs dialogs;
    private final SettingsKeeper settings;
    private final Errands errands;
    private final BooleanSupplier takeTyped;
    private int saving;

    /** Used only by the thread that writes scenes. */
    private Optional<EditedFile> lastWritten = Optional.empty();

    /**
     * Saves the scene of a studio.
     *
     * @param takeTyped enters what is typed in the panel; false if it is invalid, which it has reported
     */
    public SceneSaving(
            Studio studio,
            FileChoice choice,
            ShippedFolders shipped,
            Dialogs dialogs,
            SettingsKeeper settings,
            Errands errands,
            BooleanSupplier takeTyped) {
        this.studio = studio;
        document = studio.document();
        this.choice = choice;
        this.shipped = shipped;
        this.dialogs = dialogs;
        this.settings = settings;
        this.errands = errands;
        this.takeTyped = takeTyped;
    }

    /** Saves to the scene's own file. */
    public void save() {
        if (takeTyped.getAsBoolean()) {
            save(() -> {});
        }
    }

    /** Asks for a file and saves to it. */
    public void saveAs() {
        if (takeTyped.getAsBoolean()) {
            saveAs(() -> {});
        }
    }

    /** Runs an action once changes are saved or discarded; not at all if that is canceled or a typed value is wrong. */
    public void afterSaving(Runnable action) {
        if (!takeTyped.getAsBoolean()) {
            return;
        }
        if (saving > 0) {
            // The thread writes scenes one after the other: after this errand all of them are written.
            errands.keepFile(
                    () -> "",
                    _ -> afterSaving(action),
                    problem -> dialogs.complain("Couldn't keep the scene", Problems.explain(problem)));
        } else if (document.editsProperty().get().changed()) {
            // The scene may be edited while it is written: so ask again afterwards.
            dialogs.askToSave(
                    FileNames.name(document.file()),
                    new Answer(needsFile() ? "Save as…" : "Save", () -> save(() -> afterSaving(action))),
                    new Answer("Don't save", action));
        } else {
            action.run();
        }
    }

    /** Whether the scene is shipped or was never saved, so that it needs a file of its own first. */
    private boolean needsFile() {
        return shipped.isScene(document.file())
                || document.fileProperty().get().mark().equals(FileMark.NONE);
    }

    private void save(Runnable then) {
        if (needsFile()) {
            saveAs(then);
        } else {
            saveTo(document.file(), then);
        }
    }

    private void saveAs(Runnable then) {
        Path own = document.file();
        Path suggested = shipped.isScene(own) ? Path.of("").toAbsolutePath().resolve(own.getFileName()) : own;
        choice.toSaveScene(suggested).ifPresent(file -> {
            if (shipped.isScene(file)) {
                dialogs.complain(
                        "Shipped scenes are read-only", file.getParent() + ": choose another folder for your scene.");
            } else {
                name(own, file);
                saveTo(file, then);
            }
        });
    }

    /** Gives a copy a title of its own. */
    private void name(Path own, Path copy) {
        if (!FileNames.absolute(own).equals(FileNames.absolute(copy))) {
            Title original = document.original().title();
            boolean isShipped = shipped.isScene(own);
            studio.edit("name", scene -> scene.withTitle(CopiedTitle.of(scene.title(), original, copy, isShipped)));
            studio.endGesture();
        }
    }

    private void saveTo(Path file, Runnable then) {
        saveTo(file, document.fileProperty().get(), then);
    }

    /**
     * Writes the scene.
     *
     * @param known the scene's own file when it was last read or written: if it has changed since, asks first
     */
    private void saveTo(Path file, EditedFile known, Runnable then) {
        // A sky that the window has drawn is kept beside the scene.
        if (!DaylightFile.movedBeside(file, studio.scene()).equals(studio.scene())) {
            studio.edit("sky", scene -> DaylightFile.movedBeside(file, scene));
            studio.endGesture();
        }
        SceneHistory.Version version = document.toSave();
        saving++;
        errands.keepFile(
                () -> {
                    if (known.isOverwrittenBy(file) && !isOwn(file)) {
                        return Optional.<EditedFile>empty();
                    }
                    DaylightFile.writeIfMissing(version.scene());
                    SceneWriter.write(version.scene(), file, known.path());
                    lastWritten = Optional.of(new EditedFile(file, FileMark.of(file)));
                    return lastWritten;
                },
                written -> {
                    saving--;
                    written.ifPresentOrElse(now -> saved(version, now, then), () -> askToOverwrite(file, then));
                },
                problem -> {
                    saving--;
                    complain(problem);
                });
    }

    /** Whether a file is as this window wrote it last, which {@code known} may not tell yet. */
    private boolean isOwn(Path file) {
        return lastWritten
                .filter(own -> own.path().equals(file) && !own.isOverwrittenBy(file))
                .isPresent();
    }

    private void saved(SceneHistory.Version version, EditedFile written, Runnable then) {
        document.saved(version, written);
        studio.notice("Saved " + written.path());
        settings.remember(written.path());
        then.run();
    }

    private void askToOverwrite(Path file, Runnable then) {
        dialogs.askToOverwrite(
                FileNames.name(file),
                new Answer("Save as…", () -> saveAs(then)),
                new Answer(
                        "Overwrite",
                        () -> errands.keepFile(
                                () -> new EditedFile(file, FileMark.of(file)),
                                seen -> saveTo(file, seen, then),
                                this::complain)));
    }

    private void complain(Throwable problem) {
        dialogs.complain("Couldn't save the scene", Problems.explain(problem));
    }
}
