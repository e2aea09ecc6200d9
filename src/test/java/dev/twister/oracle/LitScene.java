package dev.twister.oracle;

import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;

/** A scene with its sky, its textures and its meshes at hand, whatever files it names. */
public record LitScene(Scene scene, SceneImages images, SceneMeshes meshes) {
    /** Without meshes. */
    public LitScene(Scene scene, SceneImages images) {
        this(scene, images, SceneMeshes.NONE);
    }

    /** Without textures either. */
    public LitScene(Scene scene, Skybox sky) {
        this(scene, SceneImages.of(sky));
    }

    public Skybox sky() {
        return images.sky();
    }

    /** At its start. */
    public World world() {
        return World.of(scene, images, meshes);
    }
}
