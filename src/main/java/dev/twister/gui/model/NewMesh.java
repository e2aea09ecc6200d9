package dev.twister.gui.model;

import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/** The mesh that a person inserts: as large as a new sphere, and where that would be. */
public final class NewMesh {
    private NewMesh() {}

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
        Vector3 middle = room.position();
        // What is flat lies where the sphere would, rather than in its middle.
        double ground = middle.y() - room.radius();
        return mesh.withScale(scale)
                .withPosition(new Vector3(
                        SceneLimits.POSITION.clamp(middle.x() - scale * center.x()),
                        SceneLimits.POSITION.clamp(ground - scale * (center.y() - half.y())),
                        SceneLimits.POSITION.clamp(middle.z() - scale * center.z())));
    }
}
