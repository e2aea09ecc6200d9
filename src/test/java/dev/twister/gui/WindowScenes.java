package dev.twister.gui;

import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import java.nio.file.Path;

/** Scenes for the window's tests. */
public final class WindowScenes {
    private WindowScenes() {}

    public static Scene shipped(String name) {
        return SceneReader.read(Path.of("scenes", name + ".json"));
    }

    /** Three spheres, quickly drawn. */
    public static Scene tiny() {
        return quick(shipped("teaching"));
    }

    /** The same with hard shadows, one reflection and one sample. */
    public static Scene quick(Scene scene) {
        return scene.withRendering(
                scene.rendering().withShadowSamples(1).withBounces(1).withSamplesPerPixel(1));
    }
}
