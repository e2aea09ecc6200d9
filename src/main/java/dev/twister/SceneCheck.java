package dev.twister;

import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Shape;
import dev.twister.scene.Triangles;
import dev.twister.scene.format.SceneWriter;

/** Checks the values of scenes that code made or changed, by the rules of scene files. */
final class SceneCheck {
    private SceneCheck() {}

    /**
     * Checks all values.
     *
     * @throws SceneException where a value is out of range; the message names it and its range
     */
    static void check(Scene scene) {
        SceneWriter.check(
                scene.withMeshes(scene.meshes().stream().map(SceneCheck::inFile).toList()));
    }

    /** No file can have triangles of code, so that a shape stands for them where values are checked. */
    private static Mesh inFile(Mesh mesh) {
        return mesh.geometry() instanceof Triangles
                ? mesh.withGeometry(Shape.of(Shape.Kind.BOX, 1)).withSmoothDegrees(0)
                : mesh;
    }
}
