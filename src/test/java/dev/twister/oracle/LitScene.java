package dev.twister.oracle;

import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;

/** A scene with its sky, textures and meshes in memory, independent of the files that it names. */
public record LitScene(Scene scene, SceneImages images, SceneMeshes meshes) {
    /** Creates a scene without meshes. */
    public LitScene(Scene scene, SceneImages images) {
        this(scene, images, SceneMeshes.NONE);
    }

    /** Creates a scene without textures and meshes. */
    public LitScene(Scene scene, Skybox sky) {
        this(scene, SceneImages.of(sky));
    }

    public Skybox sky() {
        return images.sky();
    }

    /** Returns the frame at time 0. */
    public World world() {
        return World.of(scene, images, meshes);
    }
}
