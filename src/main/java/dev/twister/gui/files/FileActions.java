package dev.twister.gui.files;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Dialogs.Answer;
import dev.twister.gui.edit.SceneHistory;
import dev.twister.gui.files.AutosaveFolder.Autosave;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.EditedFile;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.gui.studio.Studio;
import dev.twister.mesh.MeshPose;
import dev.twister.mesh.MeshStage;
import dev.twister.scene.Camera;
import dev.twister.scene.Geometry;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.light.Lights;
import dev.twister.sky.ShippedSky;
import dev.twister.sky.SkyException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;

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
    private final BackgroundTasks tasks;

    public FileActions(
            Studio studio,
            FileChoice choice,
            ShippedFolders shipped,
            Dialogs dialogs,
            SettingsKeeper settings,
            Reading reading,
            SceneSaving saving,
            AssetActions assets,
            BackgroundTasks tasks) {
        this.tasks = tasks;
        this.studio = studio;
        this.choice = choice;
        this.shipped = shipped;
        this.dialogs = dialogs;
        this.settings = settings;
        this.reading = reading;
        this.saving = saving;
        this.assets = assets;
    }

    /** Shows a new scene, once changes are saved or discarded. */
    public void newScene() {
        Path sky = FileNames.absolute(shipped.skyboxes().resolve(ShippedSky.DAY.fileName()));
        Path file = Path.of("").toAbsolutePath().resolve(NewScene.FILE_NAME);
        saving.afterSaving(() -> studio.show(new OpenedScene(file, NewScene.of(sky))));
    }

    /** Lists the shipped scenes in the background; tells nothing if there are none. */
    public void listShipped(Consumer<List<Path>> then) {
        tasks.run(shipped::list, then, _ -> {});
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
                        case SCENE -> saving.afterSaving(() -> openScene(file));
                        case SKYBOX -> assets.useSky(file, () -> {});
                        case MESH -> saving.afterSaving(() -> openMesh(file));
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
        Mesh mesh = Mesh.of(absolute).withSmoothDegrees(MeshStage.SMOOTH_DEGREES);
        Path sky = FileNames.absolute(shipped.skyboxes().resolve(ShippedSky.DAY.fileName()));
        assets.readMesh(mesh, unlessEdited(held -> {
            studio.assets().keepMesh(mesh, held);
            studio.show(new OpenedScene(
                    MeshStage.sceneFile(absolute),
                    MeshStage.of(new Geometry.OfFile(absolute), held, sky, MeshPose.OF_FILE)));
            settings.remember(file);
        }));
    }

    private void openScene(Path file) {
        reading.begin(
                FileNames.name(file),
                () -> studio.assets().readWithOrWithoutSky(file),
                unlessEdited(read -> read.skyProblem()
                        .ifPresentOrElse(problem -> offerAnotherSky(read.opened(), problem), () -> {
                            studio.show(read.opened());
                            settings.remember(file);
                        })),
                problem -> {
                    settings.forgetIfGone(file);
                    complain("Couldn't open the scene", problem);
                },
                () -> {});
    }

    /** Asks again about changes made while a file was read. */
    private <T> Consumer<T> unlessEdited(Consumer<T> then) {
        SceneHistory.Version before = studio.document().present();
        return read -> {
            if (studio.document().present().isSame(before)) {
                then.accept(read);
            } else {
                saving.afterSaving(() -> then.accept(read));
            }
        };
    }

    /** Offers to open a scene under another sky. */
    private void offerAnotherSky(OpenedScene read, Throwable problem) {
        Path present = studio.scene().sky().file();
        dialogs.askForSky(
                Dialogs.explain(problem),
                new Answer(
                        "Choose a sky…",
                        () -> choice.panorama(studio.document().folder()).ifPresent(sky -> showUnder(sky, read))),
                new Answer("Use the present sky", () -> showUnder(present, read)));
    }

    private void showUnder(Path sky, OpenedScene read) {
        reading.begin(
                FileNames.name(sky),
                () -> {
                    studio.assets().readSky(sky);
                    return read.scene().withSky(read.scene().sky().withFile(sky));
                },
                unlessEdited(scene -> {
                    studio.restore(read.withScene(scene), scene);
                    settings.remember(read.file().path());
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
        saving.afterSaving(() -> reading.begin(
                FileNames.name(autosave.edited().path()),
                () -> {
                    Scene edited = edited(autosave.file(), present);
                    return new Restored(before(autosave.edited(), edited), edited);
                },
                unlessEdited(restored -> {
                    studio.restore(restored.before(), restored.edited());
                    then.run();
                }),
                problem -> {
                    failed.run();
                    complain("Couldn't restore the changes", problem);
                },
                failed));
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
        dialogs.complain(title, Dialogs.explain(problem));
    }

    /** The scene that a person starts from: a floor, a sky and a light, path traced. */
    private static final class NewScene {
        /** Its file until it is saved for the first time. */
        static final String FILE_NAME = "untitled.json";

        private static final double FLOOR_METERS = 20;
        private static final Camera CAMERA = Camera.of(new Vector3(0, 2, -7), 0, 10, 50);
        private static final Light LIGHT = Light.of(new Vector3(-3, 6, -4), 0.5, new Rgb(1, 0.95, 0.85));
        private static final Rgb BRIGHT = new Rgb(0.7, 0.7, 0.7);
        private static final Rgb DARK = new Rgb(0.4, 0.4, 0.4);
        private static final int SHADOW_SAMPLES = 16;

        private NewScene() {}

        /**
         * The scene under a sky.
         *
         * @param sky a panorama's file
         */
        static Scene of(Path sky) {
            Rendering rendering = Rendering.DEFAULT;
            return Scene.under(sky)
                    .withCamera(CAMERA)
                    .withGround(Ground.of(FLOOR_METERS, 0, BRIGHT, DARK, 0))
                    .withLights(Lights.of(LIGHT))
                    .withRendering(rendering
                            .withIntegrator(Integrator.PATH)
                            .withShadowSamples(SHADOW_SAMPLES)
                            .withTone(rendering.exposure(), ToneMap.ACES, rendering.srgb()));
        }
    }
}
