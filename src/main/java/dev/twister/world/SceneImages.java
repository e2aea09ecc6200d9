package dev.twister.world;

import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.Map;

/**
 * The pictures that a scene names.
 *
 * @param textureByFile the textures of its materials, by the path that a material has
 */
public record SceneImages(Skybox sky, Map<Path, Skybox> textureByFile) {
    public SceneImages {
        textureByFile = Map.copyOf(textureByFile);
    }

    /** Of a scene without textures. */
    public static SceneImages of(Skybox sky) {
        return new SceneImages(sky, Map.of());
    }
}
