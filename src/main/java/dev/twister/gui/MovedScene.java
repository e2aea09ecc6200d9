package dev.twister.gui;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.Motion;
import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A scene with its spheres where the physics has brought them. */
final class MovedScene {
    private MovedScene() {}

    /** The scene as the picture shows it; the scene itself where nothing moves or the picture is of another one. */
    static Scene of(Scene scene, Motion motion, Optional<DrawnPicture> picture) {
        return picture.filter(shown -> motion.isOn()
                        && shown.request().motion().start() == motion.start()
                        && shown.request().scene().spheres().equals(scene.spheres()))
                .map(shown -> scene.withSpheres(moved(scene, shown.input().bodyPositions())))
                .orElse(scene);
    }

    /** Whether the physics sees the same in both scenes. */
    static boolean movesAlike(Scene one, Scene other) {
        return one.spheres().equals(other.spheres())
                && one.light().equals(other.light())
                && one.plane().equals(other.plane())
                && one.physics().equals(other.physics())
                && one.pour().equals(other.pour());
    }

    private static List<Sphere> moved(Scene scene, float[] positions) {
        List<Sphere> spheres = new ArrayList<>(scene.spheres().size());
        for (int index = 0; index < scene.spheres().size(); index++) {
            Sphere sphere = scene.spheres().get(index);
            int at = 3 * (Layout.FIRST_SPHERE + index);
            Vector3 place = new Vector3(
                    SceneLimits.POSITION.clamp(positions[at]),
                    SceneLimits.POSITION.clamp(positions[at + 1]),
                    SceneLimits.POSITION.clamp(positions[at + 2]));
            spheres.add(new Sphere(place, sphere.radius(), sphere.color(), sphere.reflectivity()));
        }
        return spheres;
    }
}
