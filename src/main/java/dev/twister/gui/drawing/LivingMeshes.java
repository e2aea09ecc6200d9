package dev.twister.gui.drawing;

import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.scene.Scene;
import dev.twister.world.SceneMeshes;
import java.util.Optional;
import java.util.function.Function;

/** The meshes of the scene that is being drawn. Used by the drawing thread alone. */
final class LivingMeshes {
    private final Function<SceneMeshes.Source, MeshFile> reader;
    private SceneMeshes held = SceneMeshes.NONE;
    private Optional<String> complaint = Optional.empty();

    LivingMeshes(Function<SceneMeshes.Source, MeshFile> reader) {
        this.reader = reader;
    }

    /** The scene's meshes; those that are at hand are not read again. Empty where one cannot be read. */
    Optional<SceneMeshes> of(Scene scene) {
        try {
            held = held.changedTo(scene, reader);
            complaint = Optional.empty();
            return Optional.of(held);
        } catch (MeshException problem) {
            complaint = Optional.of(problem.getMessage());
        } catch (OutOfMemoryError _) {
            complaint = Optional.of("there is not enough memory for the scene's meshes");
        }
        return Optional.empty();
    }

    /** Why the meshes are not seen, where they are not. */
    Optional<String> complaint() {
        return complaint;
    }
}
