package dev.twister.gui.model;

import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;

/** The mesh that the user inserts: of the size of a new sphere, see {@link FreePlace}. */
public final class NewMesh {
    private NewMesh() {}

    /** A new shape of the usual proportions, made of what a new sphere would be. */
    public static Mesh inFrontOf(FrameInput input, Scene scene, SceneMeshes meshes, Shape.Kind kind) {
        Shape shape = Shape.of(kind, 2 * NewSphere.RADIUS);
        return Mesh.of(shape)
                .withMaterial(NewSphere.material(scene))
                .withPosition(middle(input, scene, meshes, shape.size().times(0.5)));
    }

    /**
     * The mesh with a place and a scale.
     *
     * @param bounds of the file's triangles, in its own coordinates
     */
    public static Mesh inFrontOf(FrameInput input, Scene scene, SceneMeshes meshes, Mesh mesh, BodyExtent bounds) {
        Vector3 half = bounds.half();
        double largest = Math.max(half.x(), Math.max(half.y(), half.z()));
        double scale = SceneLimits.SCALE.clamp(largest > 0 ? NewSphere.RADIUS / largest : 1);
        Vector3 middle = middle(input, scene, meshes, half.times(scale));
        return mesh.withScale(scale)
                .withPosition(
                        SceneLimits.POSITION.clamp(middle.minus(bounds.middle().times(scale))));
    }

    private static Vector3 middle(FrameInput input, Scene scene, SceneMeshes meshes, Vector3 half) {
        return FreePlace.of(input, scene, meshes, BodyExtent.box(Vector3.ZERO, half));
    }
}
