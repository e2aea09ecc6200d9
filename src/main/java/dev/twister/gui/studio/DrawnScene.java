package dev.twister.gui.studio;

import dev.twister.scene.Scene;
import dev.twister.scene.light.Lights;
import dev.twister.scene.select.SceneBodies;
import dev.twister.scene.select.VisibleBodies;
import java.nio.file.Path;

/** The visible part of the scene. What an edit does not change stays the same list, which is compared at once. */
final class DrawnScene {
    private Scene whole = Scene.under(Path.of(""));
    private SceneBodies bodies = whole.bodies();
    private Lights lights = whole.lights();

    /** See {@link VisibleBodies#of}; its tracks are those of the whole scene, as a picture has none. */
    @SuppressWarnings("ReferenceEquality") // an edit makes a new record; to compare all spheres takes longer
    Scene of(Scene scene) {
        if (scene.bodies() != whole.bodies() || scene.lights() != whole.lights()) {
            Scene visible = VisibleBodies.of(scene);
            bodies = visible.bodies().equals(bodies) ? bodies : visible.bodies();
            lights = visible.lights().equals(lights) ? lights : visible.lights();
            whole = scene;
        }
        return scene.withBodies(bodies).withLights(lights);
    }
}
