package dev.twister.gui.model;

import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/** The mesh that the user inserts: of the size and at the place of a new sphere. */
public final class NewMesh {
    private NewMesh() {}

    /** A new shape of the usual proportions, made of what a new sphere would be. */
    public static Mesh inFrontOf(FrameInput input, Scene scene, Shape.Kind kind) {
        Sphere room = NewSphere.inFrontOf(input, scene);
        Shape shape = Shape.of(kind, 2 * room.radius());
        Vector3 up = new Vector3(0, shape.size().y() / 2 - room.radius(), 0);
        return Mesh.of(shape)
                .withMaterial(room.material())
                .withPosition(SceneLimits.POSITION.clamp(room.position().plus(up)));
    }

    /**
     * The mesh with a place and a scale.
     *
     * @param center of the box around the file's triangles, in its own coordinates
     * @param half of each of the box's sides
     */
    public static Mesh inFrontOf(FrameInput input, Scene scene, Mesh mesh, Vector3 center, Vector3 half) {
        Sphere room = NewSphere.inFrontOf(input, scene);
        double largest = Math.max(half.x(), Math.max(half.y(), half.z()));
        double scale = SceneLimits.SCALE.clamp(largest > 0 ? room.radius() / largest : 1);
        // A flat mesh lies on the ground, not at the sphere's center.
        Vector3 bottom = new Vector3(center.x(), center.y() - half.y(), center.z());
        Vector3 ground = room.position().minus(new Vector3(0, room.radius(), 0));
        return mesh.withScale(scale).withPosition(SceneLimits.POSITION.clamp(ground.minus(bottom.times(scale))));
    }
}
