package dev.twister.gui.files;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Dialogs.Answer;
import dev.twister.gui.edit.SceneHistory;
import dev.twister.gui.property.DaylightFile;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Document;
import dev.twister.gui.studio.EditedFile;
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
    private final BackgroundTasks tasks;
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
            BackgroundTasks tasks,
            BooleanSupplier takeTyped) {
        this.studio = studio;
        document = studio.document();
        this.choice = choice;
        this.shipped = shipped;
        this.dialogs = dialogs;
        this.settings = settings;
        this.tasks = tasks;
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
            // The thread writes scenes one after the other: after this task all of them are written.
            tasks.keepFile(
                    () -> "",
                    _ -> afterSaving(action),
                    problem -> dialogs.complain("Couldn't keep the scene", Dialogs.explain(problem)));
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
                || document.fileProperty().get().mark().equals(EditedFile.Digest.NONE);
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
            studio.editOnce("name", scene -> scene.withTitle(copiedTitle(scene.title(), original, copy, isShipped)));
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
            studio.editOnce("sky", scene -> DaylightFile.movedBeside(file, scene));
        }
        SceneHistory.Version version = document.toSave();
        saving++;
        tasks.keepFile(
                () -> {
                    if (known.isOverwrittenBy(file) && !isOwn(file)) {
                        return Optional.<EditedFile>empty();
                    }
                    DaylightFile.writeIfMissing(version.scene());
                    SceneWriter.write(version.scene(), file, known.path());
                    lastWritten = Optional.of(new EditedFile(file, EditedFile.Digest.of(file)));
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
                        () -> tasks.keepFile(
                                () -> new EditedFile(file, EditedFile.Digest.of(file)),
                                seen -> saveTo(file, seen, then),
                                this::complain)));
    }

    private void complain(Throwable problem) {
        dialogs.complain("Couldn't save the scene", Dialogs.explain(problem));
    }

    /**
     * The title of the copy.
     *
     * @param title that the scene has now
     * @param original that of the file it was read from
     * @param shipped whether that is a shipped scene, whose description is of no other
     */
    public static Title copiedTitle(Title title, Title original, Path copy, boolean shipped) {
        Title named = title.name().equals(original.name()) ? title.withName(stem(copy)) : title;
        boolean described = !shipped || !title.description().equals(original.description());
        return described ? named : named.withDescription("");
    }

    private static String stem(Path file) {
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }
}
