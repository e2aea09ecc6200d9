package dev.twister.gui.studio;

import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.SceneReader;
import java.nio.file.Path;
import java.util.function.Consumer;

/**
 * A scene that has been read.
 *
 * @param file the file it was read from
 */
public record OpenedScene(EditedFile file, Scene scene) {
    /** A scene that is in no file yet. */
    public OpenedScene(Path file, Scene scene) {
        this(new EditedFile(file, EditedFile.Digest.NONE), scene);
    }

    /**
     * Reads a scene file.
     *
     * @throws dev.twister.scene.SceneException if it is not a scene
     */
    public static OpenedScene read(Path file) {
        // First: a file that is replaced while it is read counts as changed.
        EditedFile.Digest mark = EditedFile.Digest.of(file);
        return new OpenedScene(new EditedFile(file, mark), SceneReader.read(file));
    }

    /**
     * Reads a scene file whose sky need not be there.
     *
     * @param skyProblem told what is wrong if only the sky is missing
     * @throws dev.twister.scene.SceneException if it is not a scene
     */
    static OpenedScene read(Path file, Consumer<SceneException> skyProblem) {
        EditedFile.Digest mark = EditedFile.Digest.of(file);
        return new OpenedScene(new EditedFile(file, mark), SceneReader.read(file, skyProblem));
    }

    /** Another scene of the same file. */
    public OpenedScene withScene(Scene other) {
        return new OpenedScene(file, other);
    }

    /**
     * Reads a scene file with another sky.
     *
     * @throws dev.twister.scene.SceneException if it is not a scene
     */
    public static OpenedScene readUnder(Path skybox, Path file) {
        EditedFile.Digest mark = EditedFile.Digest.of(file);
        return new OpenedScene(
                new EditedFile(file, mark),
                SceneReader.readUnder(skybox.toAbsolutePath().normalize(), file));
    }
}
