package dev.twister.gui.studio;

import dev.twister.gui.model.EditedFile;
import dev.twister.gui.model.FileMark;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import java.nio.file.Path;

/**
 * A scene that was read and can be shown.
 *
 * @param file where it came from
 */
public record OpenedScene(EditedFile file, Scene scene) {
    /** A scene that no file has yet. */
    public OpenedScene(Path file, Scene scene) {
        this(new EditedFile(file, FileMark.NONE), scene);
    }

    /**
     * Reads a scene's file.
     *
     * @throws dev.twister.scene.SceneException where it is not a scene
     */
    public static OpenedScene read(Path file) {
        // First, so that a file that is replaced meanwhile counts as changed.
        FileMark mark = FileMark.of(file);
        return new OpenedScene(new EditedFile(file, mark), SceneReader.read(file));
    }

    /**
     * The same with another sky than the file's.
     *
     * @throws dev.twister.scene.SceneException where it is not a scene
     */
    public static OpenedScene readUnder(Path skybox, Path file) {
        FileMark mark = FileMark.of(file);
        return new OpenedScene(
                new EditedFile(file, mark),
                SceneReader.readUnder(skybox.toAbsolutePath().normalize(), file));
    }
}
