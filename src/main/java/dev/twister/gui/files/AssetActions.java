package dev.twister.gui.files;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.edit.BodyExtent;
import dev.twister.gui.picking.NewBodies;
import dev.twister.gui.studio.Document;
import dev.twister.gui.studio.Studio;
import dev.twister.mesh.Box;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshStage;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** Adds meshes, panoramas and textures to the scene, once their files are read. */
public final class AssetActions {
    private final Studio studio;
    private final Document document;
    private final FileChoice choice;
    private final Dialogs dialogs;
    private final SettingsKeeper settings;
    private final Reading reading;

    public AssetActions(Studio studio, FileChoice choice, Dialogs dialogs, SettingsKeeper settings, Reading reading) {
        this.studio = studio;
        document = studio.document();
        this.choice = choice;
        this.dialogs = dialogs;
        this.settings = settings;
        this.reading = reading;
    }

    /** Asks for a mesh file, and adds it to the scene in the middle of the picture. */
    public void insertMesh() {
        long number = document.number();
        choice.mesh(document.folder()).map(FileNames::absolute).map(Mesh::of).ifPresent(chosen -> {
            Mesh mesh = chosen.withSmoothDegrees(MeshStage.SMOOTH_DEGREES);
            readMesh(mesh, held -> {
                if (document.number() == number) {
                    insert(mesh, held);
                }
            });
        });
    }

    private void insert(Mesh mesh, MeshFile held) {
        studio.pictureProperty().get().ifPresent(shown -> {
            Box box = held.bounds();
            BodyExtent bounds = BodyExtent.box(box.center(), box.half());
            Mesh placed = NewBodies.mesh(shown.input(), studio.bodies().scene(), shown.meshes(), mesh, bounds);
            studio.assets().keepMesh(mesh, held);
            studio.insert("insert mesh", List.of(placed), List.of());
        });
    }

    void readMesh(Mesh mesh, Consumer<MeshFile> then) {
        reading.begin(
                mesh.geometry().name(),
                () -> studio.assets().readMesh(mesh),
                then,
                problem -> {
                    mesh.file().ifPresent(settings::forgetIfGone);
                    complain("Couldn't open the mesh", problem);
                },
                () -> {});
    }

    /** Asks for a panorama, and makes it the sky. */
    public void chooseSky() {
        choice.panorama(Optional.ofNullable(studio.scene().sky().file().getParent())
                        .orElse(document.folder()))
                .ifPresent(file -> useSky(file, () -> {}));
    }

    /**
     * Makes a panorama the sky once it is read; if that fails, the old one stays.
     *
     * @param refused called if it cannot be read or reading is canceled
     */
    public void useSky(Path panorama, Runnable refused) {
        Path file = FileNames.absolute(panorama);
        reading.begin(
                FileNames.name(file),
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

    /** Asks for a texture file, starting in the folder of the present one. */
    public void chooseTexture(Optional<Path> present, Consumer<Path> then) {
        choice.texture(present.map(Path::getParent).orElse(document.folder()))
                .map(FileNames::absolute)
                .ifPresent(then);
    }

    /**
     * Reads a texture for the selected body.
     *
     * @param then called once it is read, unless another body is selected by then
     * @param refused called if it cannot be read or reading is canceled
     */
    public void readTexture(Path file, Runnable then, Runnable refused) {
        Scene scene = studio.scene();
        int body = studio.selection().active();
        long number = document.number();
        reading.begin(
                FileNames.name(file),
                () -> {
                    studio.assets().readTexture(scene, file);
                    return file;
                },
                _ -> {
                    if (document.number() == number && studio.selection().active() == body) {
                        then.run();
                    }
                },
                problem -> {
                    refused.run();
                    complain("Couldn't load the texture", problem);
                },
                refused);
    }

    private void complain(String title, Throwable problem) {
        dialogs.complain(title, Dialogs.explain(problem));
    }
}
