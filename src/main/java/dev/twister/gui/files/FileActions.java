package dev.twister.gui.files;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Dialogs.Answer;
import dev.twister.gui.controls.Problems;
import dev.twister.gui.model.Autosave;
import dev.twister.gui.model.DroppedFile;
import dev.twister.gui.model.EditedFile;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.gui.studio.Studio;
import dev.twister.mesh.MeshPose;
import dev.twister.mesh.MeshStage;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.SceneReader;
import dev.twister.sky.ShippedSky;
import dev.twister.sky.SkyException;
import java.nio.file.Path;
import java.util.List;

/** Opens scenes, meshes and panoramas: from the menu, by a key, or dropped on the window. */
public final class FileActions {
    private final Studio studio;
    private final FileChoice choice;
    private final ShippedFolders shipped;
    private final Dialogs dialogs;
    private final SettingsKeeper settings;
    private final Reading reading;
    private final SceneSaving saving;
    private final AssetActions assets;

    public FileActions(
            Studio studio,
            FileChoice choice,
            ShippedFolders shipped,
            Dialogs dialogs,
            SettingsKeeper settings,
            Reading reading,
            SceneSaving saving,
            AssetActions assets) {
        this.studio = studio;
        this.choice = choice;
        this.shipped = shipped;
        this.dialogs = dialogs;
        this.settings = settings;
        this.reading = reading;
        this.saving = saving;
        this.assets = assets;
    }

    /** Asks for a file and opens it. */
    public void open() {
        choice.toOpen(studio.document().folder()).ifPresent(this::open);
    }

    /**
     * Opens a scene, or a mesh in a scene of its own, once changes are saved or discarded; makes a panorama the sky.
     * Reports any other file as an error.
     */
    public void open(Path file) {
        reading.begin(
                FileNames.name(file),
                () -> DroppedFile.kind(file),
                kind -> {
                    switch (kind) {
                        case SCENE -> openScene(file);
                        case SKYBOX -> assets.useSky(file, () -> {});
                        case MESH -> openMesh(file);
                        case OTHER -> {
                            settings.forgetIfGone(file);
                            dialogs.complain("Couldn't open the file", DroppedFile.complaint(file));
                        }
                    }
                },
                problem -> complain("Couldn't open the file", problem),
                () -> {});
    }

    /** Opens the first of the dropped files; tells it if there are several. */
    public void drop(List<Path> files) {
        if (files.size() > 1) {
            studio.notice("One file at a time: opening " + files.getFirst().getFileName());
        }
        files.stream().findFirst().ifPresent(this::open);
    }

    /** Shows a mesh in a scene of its own. */
    private void openMesh(Path file) {
        Path absolute = FileNames.absolute(file);
        Mesh mesh = Mesh.of(absolute).withSmooth(MeshStage.SMOOTH_DEGREES);
        Path sky = FileNames.absolute(shipped.skyboxes().resolve(ShippedSky.DAY.fileName()));
        assets.readMesh(mesh, held -> {
            Scene stage = MeshStage.of(absolute, held, sky, MeshPose.OF_FILE);
            saving.afterSaving(() -> {
                studio.assets().keepMesh(mesh, held);
                studio.show(new OpenedScene(MeshStage.sceneFile(absolute), stage));
                settings.remember(file);
            });
        });
    }

    private void openScene(Path file) {
        reading.begin(
                FileNames.name(file),
                () -> studio.assets().readScene(file),
                // Ask only once the new scene has been read.
                opened -> saving.afterSaving(() -> {
                    studio.show(opened);
                    settings.remember(file);
                }),
                problem -> {
                    settings.forgetIfGone(file);
                    offerAnotherSky(file, problem);
                },
                () -> {});
    }

    /** Offers to open a scene under another sky if only its own cannot be read. */
    private void offerAnotherSky(Path file, Throwable problem) {
        Path present = studio.scene().sky().file();
        reading.begin(
                FileNames.name(file),
                () -> {
                    OpenedScene read = OpenedScene.readUnder(present, file);
                    studio.assets().readTextures(read.scene());
                    return read;
                },
                _ -> dialogs.askForSky(
                        Problems.explain(problem),
                        new Answer(
                                "Choose a sky…",
                                () -> choice.panorama(studio.document().folder())
                                        .ifPresent(sky -> openUnder(sky, file))),
                        new Answer("Use the present sky", () -> openUnder(present, file))),
                _ -> complain("Couldn't open the scene", problem),
                () -> {});
    }

    private void openUnder(Path sky, Path file) {
        reading.begin(
                FileNames.name(file),
                () -> {
                    studio.assets().readSky(sky);
                    OpenedScene read = OpenedScene.readUnder(sky, file);
                    studio.assets().readTextures(read.scene());
                    return read;
                },
                opened -> saving.afterSaving(() -> {
                    studio.restore(opened, opened.scene());
                    settings.remember(file);
                }),
                problem -> complain("Couldn't load the sky", problem),
                () -> {});
    }

    /**
     * Shows autosaved edits, once those of the present scene are saved or discarded.
     *
     * @param then called when they are shown
     * @param failed called if they cannot be
     */
    void restore(Autosave autosave, Runnable then, Runnable failed) {
        Path present = studio.scene().sky().file();
        reading.begin(
                FileNames.name(autosave.edited().path()),
                () -> {
                    Scene edited = edited(autosave.file(), present);
                    return new Restored(before(autosave.edited(), edited), edited);
                },
                restored -> saving.afterSaving(() -> {
                    studio.restore(restored.before(), restored.edited());
                    then.run();
                }),
                problem -> {
                    failed.run();
                    complain("Couldn't restore the changes", problem);
                },
                failed);
    }

    /** The edited scene; under the present sky if its own cannot be read any more. */
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

    /** The scene in its file; the edited one if that cannot be read any more. */
    private OpenedScene before(EditedFile file, Scene edited) {
        try {
            return new OpenedScene(file, studio.assets().readScene(file.path()).scene());
        } catch (SceneException | SkyException _) {
            return new OpenedScene(file, edited);
        }
    }

    private void complain(String title, Throwable problem) {
        dialogs.complain(title, Problems.explain(problem));
    }
}
