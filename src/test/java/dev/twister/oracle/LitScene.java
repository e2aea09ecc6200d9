package dev.twister.oracle;

import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;

/** A scene with its sky and its textures at hand, whatever files it names. */
public record LitScene(Scene scene, SceneImages images) {
    /** Without textures. */
    public LitScene(Scene scene, Skybox sky) {
        this(scene, SceneImages.of(sky));
    }

    public Skybox sky() {
        return images.sky();
    }
}
