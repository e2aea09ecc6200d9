package dev.twister.world;

import dev.twister.mesh.MeshPart;
import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.format.TexturePlaces;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.sky.TextureImage;
import dev.twister.sky.TextureReader;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The images that a scene refers to.
 *
 * @param textureByFile textures by the path in their material
 */
public record SceneImages(Skybox sky, Map<Path, TextureImage> textureByFile) {
    /** A texture that leaves colors unchanged. */
    public static final Skybox WHITE = new Skybox(1, 1, new float[] {1, 1, 1});

    public SceneImages {
        textureByFile = Map.copyOf(textureByFile);
    }

    /**
     * Reads a scene's images, each file once.
     *
     * @param warnings receives one line for each unsupported feature of a file
     * @throws SkyException as for {@link SkyboxReader#read} and {@link #textures}
     */
    public static SceneImages read(Scene scene, Consumer<String> warnings) {
        return new SceneImages(
                SkyboxReader.read(scene.sky().file(), warnings),
                textures(scene, file -> TextureReader.read(file, warnings)));
    }

    /**
     * As above, for a scene with meshes; warns of textures that are not shown, too.
     *
     * @throws SkyException as for {@link SkyboxReader#read} and {@link #textures}
     */
    public static SceneImages read(Scene scene, SceneMeshes meshes, Consumer<String> warnings) {
        return read(scene, SkyboxReader.read(scene.sky().file(), warnings), meshes, warnings);
    }

    /**
     * As above, with another sky than the scene's own.
     *
     * @throws SkyException as for {@link #textures}
     */
    public static SceneImages read(Scene scene, Skybox sky, SceneMeshes meshes, Consumer<String> warnings) {
        HiddenTextures.of(scene, meshes).forEach(warnings);
        if (scene.rendering().integrator() == Integrator.WHITTED) {
            hiddenFinishes(scene, meshes).ifPresent(warnings);
        }
        return new SceneImages(
                sky,
                textures(
                        scene,
                        meshes,
                        file -> meshes.embeddedImage(file)
                                .map(bytes -> TextureReader.read(file, bytes, warnings))
                                .orElseGet(() -> TextureReader.read(file, warnings)),
                        warnings));
    }

    /** A line that names what path tracing alone shows of the materials, if that is anything. */
    private static Optional<String> hiddenFinishes(Scene scene, SceneMeshes meshes) {
        Stream<Material> ofMeshes = scene.meshes().stream()
                .flatMap(mesh -> mesh.material()
                        .map(Stream::of)
                        .orElseGet(() -> meshes.file(mesh).parts().stream().map(MeshPart::material)));
        Stream<Material> others = Stream.concat(
                Stream.of(scene.ground().material()), scene.spheres().stream().map(Sphere::material));
        Set<String> names = new TreeSet<>();
        Stream.concat(others, ofMeshes)
                .filter(Material::hasFinish)
                .forEach(material -> names.addAll(material.finish().parts()));
        return names.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        "not shown without path tracing: " + String.join(", ", names) + "; try --integrator path");
    }

    /**
     * A scene's textures by file, including those of the meshes' own materials, which may be embedded in a mesh file;
     * of those, {@link #WHITE} replaces one that cannot be read.
     *
     * @param reader reads a texture, like {@link TextureReader#read}
     * @param warnings receives one line for each texture of a mesh's own material that cannot be read
     * @throws SkyException if the reader does for a texture that the scene file names; the message includes where
     */
    public static Map<Path, TextureImage> textures(
            Scene scene, SceneMeshes meshes, Function<Path, TextureImage> reader, Consumer<String> warnings) {
        Map<Path, TextureImage> textures = new HashMap<>(textures(scene, reader));
        meshes.textures(scene)
                .forEach((file, place) ->
                        textures.computeIfAbsent(file, texture -> textureOrWhite(texture, place, reader, warnings)));
        return textures;
    }

    private static TextureImage textureOrWhite(
            Path file, String place, Function<Path, TextureImage> reader, Consumer<String> warnings) {
        try {
            return texture(file, place, reader);
        } catch (SkyException problem) {
            warnings.accept(problem.getMessage() + "; rendered without this texture");
            return WHITE;
        }
    }

    /**
     * A scene's textures by file.
     *
     * @param reader reads a texture, like {@link TextureReader#read}
     * @throws SkyException if the reader does; the message includes where the scene file refers to the texture
     */
    public static Map<Path, TextureImage> textures(Scene scene, Function<Path, TextureImage> reader) {
        Map<Path, TextureImage> textures = new HashMap<>();
        TexturePlaces.of(scene).forEach((file, place) -> textures.put(file, texture(file, place, reader)));
        return textures;
    }

    private static TextureImage texture(Path file, String place, Function<Path, TextureImage> reader) {
        try {
            return reader.apply(file);
        } catch (SkyException problem) {
            throw new SkyException(place + ": " + problem.getMessage(), problem);
        }
    }

    /** The images of a scene without textures. */
    public static SceneImages of(Skybox sky) {
        return new SceneImages(sky, Map.of());
    }
}
