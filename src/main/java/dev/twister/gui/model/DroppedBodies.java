package dev.twister.gui.model;

import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.SceneMeshes;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/** Bodies that are put on the ground. */
public final class DroppedBodies {
    private DroppedBodies() {}

    /**
     * The scene with spheres and meshes standing on the ground; lights, locked bodies and meshes that have not been
     * read stay.
     *
     * @param meshes of the scene
     */
    public static Scene of(Scene scene, SceneMeshes meshes, Set<Integer> bodies) {
        double ground = scene.ground().height();
        Map<Integer, Vector3> places = new LinkedHashMap<>();
        for (int body : bodies) {
            boolean unread = BodyEdits.isMesh(scene, body) && !meshes.holds(BodyEdits.mesh(scene, body));
            if (BodyEdits.isSolid(scene, body) && BodyEdits.isFree(scene, body) && !unread) {
                Vector3 now = BodyEdits.position(scene, body);
                double lowest = lowest(scene, meshes, body);
                places.put(body, SceneLimits.POSITION.clamp(Axis.Y.with(now, now.y() + ground - lowest)));
            }
        }
        return BodyEdits.moved(scene, places);
    }

    private static double lowest(Scene scene, SceneMeshes meshes, int body) {
        if (BodyEdits.isSphere(scene, body)) {
            return BodyEdits.position(scene, body).y()
                    - BodyEdits.sphere(scene, body).radius();
        }
        Mesh mesh = BodyEdits.mesh(scene, body);
        return meshes.farPoints(mesh).stream()
                .mapToDouble(Vector3::y)
                .min()
                .orElse(mesh.position().y());
    }
}
