package dev.twister.gui.files;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Dialogs.Answer;
import dev.twister.gui.model.Autosave;
import dev.twister.gui.model.DroppedFile;
import dev.twister.gui.model.EditedFile;
import dev.twister.gui.model.FileMark;
import dev.twister.gui.model.NewMesh;
import dev.twister.gui.model.SceneHistory;
import dev.twister.gui.studio.Errands;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.gui.studio.Studio;
import dev.twister.mesh.Box;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshStage;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.format.SceneWriter;
import dev.twister.sky.ShippedSky;
import dev.twister.sky.SkyException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** Opens and saves: what the menu, a key, or a file dropped on the window asks for. */
public final class FileActions {
    private final Studio studio;
    private final FileChoice choice;
    private final ShippedFolders shipped;
    private final Dialogs dialogs;
    private final SettingsKeeper settings;
    private final Errands errands;
    private final Reading reading;
    private final BooleanSupplier takeTyped;
    private int saving;

    /** Used by the thread alone that writes scenes. */
    private Optional<EditedFile> lastWritten = Optional.empty();

    /**
     * Actions on the scene that the studio has.
     *
     * @param takeTyped makes an edit of what is typed and not yet entered; false where that is wrong, which it has said
     */
    public FileActions(
            Studio studio,
            FileChoice choice,
            ShippedFolders shipped,
            Dialogs dialogs,
            SettingsKeeper settings,
            Errands errands,
            Reading reading,
            BooleanSupplier takeTyped) {
        this.studio = studio;
        this.choice = choice;
        this.shipped = shipped;
        this.dialogs = dialogs;
        this.settings = settings;
        this.errands = errands;
        this.reading = reading;
        this.takeTyped = takeTyped;
    }

    /** Asks which file, and opens it. */
    public void open() {
        choice.toOpen(folder()).ifPresent(this::open);
    }

    /**
     * Opens a scene, or a mesh in a scene of its own, once changes are saved or given up; a panorama becomes the sky.
     * What is none of them is complained of.
     */
    public void open(Path file) {
        reading.begin(
                name(file),
                () -> DroppedFile.kind(file),
                kind -> {
                    switch (kind) {
                        case SCENE -> openScene(file);
                        case SKYBOX -> useSky(file);
                        case MESH -> openMesh(file);
                        case OTHER -> {
                            forgetWhereGone(file);
                            dialogs.complain("Couldn't open the file", DroppedFile.complaint(file));
                        }
                    }
                },
                problem -> complain("Couldn't open the file", problem),
                () -> {});
    }

    /** Opens the first of the files that were dropped; with several, says so. */
    public void drop(List<Path> files) {
        if (files.size() > 1) {
            studio.notice("One file at a time: opening " + files.getFirst().getFileName());
        }
        files.stream().findFirst().ifPresent(this::open);
    }

    /** Asks which mesh, and adds it to the scene, in the middle of the picture. */
    public void insertMesh() {
        long document = studio.document();
        choice.mesh(folder()).map(FileActions::absolute).map(Mesh::of).ifPresent(chosen -> {
            Mesh mesh = chosen.withSmooth(MeshStage.SMOOTH_DEGREES);
            readMesh(mesh, held -> {
                if (studio.document() == document) {
                    insert(mesh, held);
                }
            });
        });
    }

    private void insert(Mesh mesh, MeshFile held) {
        studio.pictureProperty().get().ifPresent(shown -> {
            Box bounds = held.bounds();
            studio.assets().keepMesh(mesh, held);
            studio.insert(
                    "insert mesh",
                    List.of(NewMesh.inFrontOf(shown.input(), studio.scene(), mesh, bounds.center(), bounds.half())));
        });
    }

    /** Shows a mesh in a scene of its own. */
    private void openMesh(Path file) {
        Mesh mesh = Mesh.of(absolute(file)).withSmooth(MeshStage.SMOOTH_DEGREES);
        Path sky = absolute(shipped.skyboxes().resolve(ShippedSky.DAY.fileName()));
        readMesh(mesh, held -> {
            Scene stage = MeshStage.of(mesh.file(), held, sky);
            afterSaving(() -> {
                studio.assets().keepMesh(mesh, held);
                studio.show(new OpenedScene(MeshStage.sceneFile(mesh.file()), stage));
                remember(file);
            });
        });
    }

    private void readMesh(Mesh mesh, Consumer<MeshFile> then) {
        reading.begin(
                name(mesh.file()),
                () -> studio.assets().readMesh(mesh),
                then,
                problem -> {
                    forgetWhereGone(mesh.file());
                    complain("Couldn't open the mesh", problem);
                },
                () -> {});
    }

    private static Path absolute(Path file) {
        return file.toAbsolutePath().normalize();
    }

    /** Asks which panorama, and makes it the sky. */
    public void chooseSky() {
        choice.panorama(Optional.ofNullable(studio.scene().sky().file().getParent())
                        .orElse(folder()))
                .ifPresent(this::useSky);
    }

    private void useSky(Path panorama) {
        useSky(panorama, () -> {});
    }

    /**
     * Makes a panorama the sky, once it has been read; the old one stays where that fails.
     *
     * @param refused called in that case, and where the person does not wait for it
     */
    public void useSky(Path panorama, Runnable refused) {
        Path file = absolute(panorama);
        reading.begin(
                name(file),
                () -> {
                    studio.assets().readSky(file);
                    return file;
                },
                studio::useSky,
                problem -> {
                    refused.run();
                    complain("Couldn't load the sky", problem);
                },
                refused);
    }

    /**
     * Asks which texture, where the present one is.
     *
     * @param then gets its file
     */
    public void chooseTexture(Optional<Path> present, Consumer<Path> then) {
        choice.texture(present.map(Path::getParent).orElse(folder()))
                .map(FileActions::absolute)
                .ifPresent(then);
    }

    /**
     * Reads a texture for the body that is selected.
     *
     * @param then called once it has been read; not where another body is selected by then
     * @param refused called where it cannot be read, and where the person does not wait for it
     */
    public void readTexture(Path file, Runnable then, Runnable refused) {
        Scene scene = studio.scene();
        int body = studio.selection().active();
        long document = studio.document();
        reading.begin(
                name(file),
                () -> {
                    studio.assets().readTexture(scene, file);
                    return file;
                },
                _ -> {
                    if (studio.document() == document && studio.selection().active() == body) {
                        then.run();
                    }
                },
                problem -> {
                    refused.run();
                    complain("Couldn't load the texture", problem);
                },
                refused);
    }

    /** Saves to the scene's own file. */
    public void save() {
        if (takeTyped.getAsBoolean()) {
            save(() -> {});
        }
    }

    public void saveAs() {
        if (takeTyped.getAsBoolean()) {
            saveAs(() -> {});
        }
    }

    /**
     * Does that once changes are saved or given up; not at all where the person would rather stay, or is typing what
     * cannot be taken.
     */
    public void afterSaving(Runnable action) {
        if (!takeTyped.getAsBoolean()) {
            return;
        }
        if (saving > 0) {
            // One scene is written after the other: then it is known whether there is something to lose.
            errands.keepScene(
                    () -> "", _ -> afterSaving(action), problem -> complain("Couldn't keep the scene", problem));
        } else if (studio.editsProperty().get().changed()) {
            // While the file is being written the scene can be edited on: that is asked about again.
            dialogs.askToSave(
                    name(file()),
                    new Answer(shipped.isScene(file()) ? "Save as…" : "Save", () -> save(() -> afterSaving(action))),
                    new Answer("Don't save", action));
        } else {
            action.run();
        }
    }

    private void openScene(Path file) {
        reading.begin(
                name(file),
                () -> studio.assets().readScene(file),
                // What cannot be opened is no reason to ask what is to become of the old scene.
                opened -> afterSaving(() -> {
                    studio.show(opened);
                    remember(file);
                }),
                problem -> {
                    forgetWhereGone(file);
                    offerAnotherSky(file, problem);
                },
                () -> {});
    }

    /** Where only the sky is at fault, the scene can be had with another. */
    private void offerAnotherSky(Path file, Throwable problem) {
        Path present = studio.scene().sky().file();
        reading.begin(
                name(file),
                () -> {
                    OpenedScene read = OpenedScene.readUnder(present, file);
                    studio.assets().readTextures(read.scene());
                    return read;
                },
                _ -> dialogs.askForSky(
                        explain(problem),
                        new Answer(
                                "Choose a sky…",
                                () -> choice.panorama(folder()).ifPresent(sky -> openUnder(sky, file))),
                        new Answer("Use the present sky", () -> openUnder(present, file))),
                _ -> complain("Couldn't open the scene", problem),
                () -> {});
    }

    private void openUnder(Path sky, Path file) {
        reading.begin(
                name(file),
                () -> {
                    studio.assets().readSky(sky);
                    OpenedScene read = OpenedScene.readUnder(sky, file);
                    studio.assets().readTextures(read.scene());
                    return read;
                },
                opened -> afterSaving(() -> {
                    studio.restore(opened, opened.scene());
                    remember(file);
                }),
                problem -> complain("Couldn't load the sky", problem),
                () -> {});
    }

    /**
     * Shows edits that were not saved, once those of the present scene are saved or given up.
     *
     * @param then called when they are shown
     * @param failed called when they cannot be
     */
    void restore(Autosave autosave, Runnable then, Runnable failed) {
        Path present = studio.scene().sky().file();
        reading.begin(
                name(autosave.edited().path()),
                () -> {
                    Scene edited = edited(autosave.file(), present);
                    return new Restored(before(autosave.edited(), edited), edited);
                },
                restored -> afterSaving(() -> {
                    studio.restore(restored.before(), restored.edited());
                    then.run();
                }),
                problem -> {
                    failed.run();
                    complain("Couldn't restore the changes", problem);
                },
                failed);
    }

    /** The edits; under the present sky where their own cannot be read any more. */
    private Scene edited(Path autosaved, Path present) {
        try {
            return studio.assets().readScene(autosaved).scene();
        } catch (SceneException | SkyException _) {
            Scene edits = SceneReader.readWithoutPictures(autosaved);
            return isReadable(edits.sky().file())
                    ? edits
                    : edits.withSky(edits.sky().withFile(present));
        }
    }

    private boolean isReadable(Path panorama) {
        try {
            studio.assets().readSky(panorama);
            return true;
        } catch (SkyException _) {
            return false;
        }
    }

    private record Restored(OpenedScene before, Scene edited) {}

    /** The scene as its file has it; as it was edited where that cannot be read any more. */
    private OpenedScene before(EditedFile file, Scene edited) {
        try {
            return new OpenedScene(file, studio.assets().readScene(file.path()).scene());
        } catch (SceneException | SkyException _) {
            return new OpenedScene(file, edited);
        }
    }

    private void save(Runnable then) {
        if (shipped.isScene(file())) {
            saveAs(then);
        } else {
            saveTo(file(), then);
        }
    }

    private void saveAs(Runnable then) {
        Path own = file();
        Path suggested = shipped.isScene(own) ? Path.of("").toAbsolutePath().resolve(own.getFileName()) : own;
        choice.toSaveScene(suggested).ifPresent(file -> {
            if (shipped.isScene(file)) {
                dialogs.complain(
                        "Shipped scenes are read-only", file.getParent() + ": choose another folder for your scene.");
            } else {
                saveTo(file, then);
            }
        });
    }

    private void saveTo(Path file, Runnable then) {
        saveTo(file, studio.fileProperty().get(), then);
    }

    /**
     * @param known how the scene's own file was when it was read or written last: it is not overwritten unasked where
     *     it has changed since
     */
    private void saveTo(Path file, EditedFile known, Runnable then) {
        SceneHistory.Version version = studio.toSave();
        saving++;
        errands.keepScene(
                () -> {
                    if (known.isOverwrittenBy(file) && !isOwn(file)) {
                        return Optional.<EditedFile>empty();
                    }
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
                    complain("Couldn't save the scene", problem);
                });
    }

    /** Whether a file is as it was written here last, of which {@code known} need not have been told yet. */
    private boolean isOwn(Path file) {
        return lastWritten
                .filter(own -> own.path().equals(file) && !own.isOverwrittenBy(file))
                .isPresent();
    }

    private void saved(SceneHistory.Version version, EditedFile written, Runnable then) {
        studio.saved(version, written);
        studio.notice("Saved " + written.path());
        remember(written.path());
        then.run();
    }

    private void askToOverwrite(Path file, Runnable then) {
        dialogs.askToOverwrite(
                name(file),
                new Answer("Save as…", () -> saveAs(then)),
                new Answer(
                        "Overwrite",
                        () -> errands.keepScene(
                                () -> new EditedFile(file, FileMark.of(file)),
                                seen -> saveTo(file, seen, then),
                                problem -> complain("Couldn't save the scene", problem))));
    }

    /** Has a scene that was opened or saved among the recent ones from now on. */
    public void remember(Path file) {
        settings.change(kept -> kept.withRecentScene(absolute(file).toString()));
        settings.write();
    }

    private void forgetWhereGone(Path file) {
        if (!Files.exists(file)) {
            settings.change(kept -> kept.withoutRecentScene(absolute(file).toString()));
        }
    }

    /** As the command line says it, where the message is meant for a person. */
    private void complain(String title, Throwable problem) {
        dialogs.complain(title, explain(problem));
    }

    public static String explain(Throwable problem) {
        return switch (problem) {
            case SceneException _, SkyException _, MeshException _, IOException _ -> problem.getMessage();
            case OutOfMemoryError _ -> "There is not enough memory for it.";
            default -> "This is a bug of Twister's: " + problem;
        };
    }

    /** The file's own name. */
    public static String name(Path file) {
        return Optional.ofNullable(file.getFileName()).map(Path::toString).orElse("the scene");
    }

    private Path file() {
        return studio.fileProperty().get().path();
    }

    /** Where the scene is, or else where the program was started. */
    private Path folder() {
        return Optional.ofNullable(file().toAbsolutePath().getParent())
                .orElse(Path.of("").toAbsolutePath());
    }
}
