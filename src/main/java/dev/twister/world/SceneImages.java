package dev.twister.world;

import dev.twister.scene.Scene;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.sky.TextureReader;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * The pictures that a scene names.
 *
 * @param textureByFile the textures of its materials, by the path that a material has
 */
public record SceneImages(Skybox sky, Map<Path, Skybox> textureByFile) {
    public SceneImages {
        textureByFile = Map.copyOf(textureByFile);
    }

    /**
     * Reads a scene's pictures, each file once.
     *
     * @param warnings told of what the files say and is not used; one line each
     * @throws SkyException as {@link SkyboxReader#read} and {@link #textures}
     */
    public static SceneImages read(Scene scene, Consumer<String> warnings) {
        return new SceneImages(
                SkyboxReader.read(scene.skybox(), warnings),
                textures(scene, file -> TextureReader.read(file, warnings)));
    }

    /**
     * The same, of a scene with meshes.
     *
     * @throws SkyException as {@link SkyboxReader#read} and {@link #textures}
     */
    public static SceneImages read(Scene scene, SceneMeshes meshes, Consumer<String> warnings) {
        return read(scene, SkyboxReader.read(scene.skybox(), warnings), meshes, warnings);
    }

    /**
     * The same under a sky that is not the scene's own.
     *
     * @throws SkyException as {@link #textures}
     */
    public static SceneImages read(Scene scene, Skybox sky, SceneMeshes meshes, Consumer<String> warnings) {
        return new SceneImages(
                sky,
                textures(
                        scene,
                        meshes,
                        file -> meshes.embeddedImage(file)
                                .map(bytes -> TextureReader.read(file, bytes, warnings))
                                .orElseGet(() -> TextureReader.read(file, warnings))));
    }

    /**
     * The same, and those of the meshes' own materials, which may be inside a mesh's file.
     *
     * @param reader reads one, as {@link TextureReader#read} does
     * @throws SkyException where the reader does; the message says where the scene file names the texture, or the mesh
     */
    public static Map<Path, Skybox> textures(Scene scene, SceneMeshes meshes, Function<Path, Skybox> reader) {
        Map<Path, Skybox> textures = new HashMap<>(textures(scene, reader));
        meshes.textures(scene)
                .forEach((file, place) -> textures.computeIfAbsent(file, texture -> texture(texture, place, reader)));
        return textures;
    }

    /**
     * A scene's textures by their files.
     *
     * @param reader reads one, as {@link TextureReader#read} does
     * @throws SkyException where the reader does; the message says where the scene file names the texture
     */
    public static Map<Path, Skybox> textures(Scene scene, Function<Path, Skybox> reader) {
        Map<Path, Skybox> textures = new HashMap<>();
        scene.textures().forEach((file, place) -> textures.put(file, texture(file, place, reader)));
        return textures;
    }

    private static Skybox texture(Path file, String place, Function<Path, Skybox> reader) {
        try {
            return reader.apply(file);
        } catch (SkyException problem) {
            throw new SkyException(place + ": " + problem.getMessage(), problem);
        }
    }

    /** Of a scene without textures. */
    public static SceneImages of(Skybox sky) {
        return new SceneImages(sky, Map.of());
    }
}
