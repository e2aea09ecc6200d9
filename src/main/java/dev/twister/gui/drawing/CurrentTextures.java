package dev.twister.gui.drawing;

import dev.twister.scene.Geometry;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.format.TexturePlaces;
import dev.twister.sky.SkyException;
import dev.twister.sky.TextureImage;
import dev.twister.sky.TextureReader;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/** The textures of the scene that is drawn. Used only by the drawing thread. */
final class CurrentTextures {
    private final ImageCache images;
    private final Supplier<Optional<Scene>> newest;
    private final Map<Path, String> complaints = new TreeMap<>();
    private Map<Path, TextureImage> held = Map.of();
    private long edition;

    /** @param newest the scene of the newest request; empty if there is none */
    CurrentTextures(ImageCache images, Supplier<Optional<Scene>> newest) {
        this.images = images;
        this.newest = newest;
    }

    /** Whether files may have changed since {@link #of} was called. */
    boolean areOld() {
        return edition != images.texturesEdition();
    }

    /** The textures of a scene and its meshes by their files; white if a file cannot be read. */
    Map<Path, TextureImage> of(Scene scene, SceneMeshes meshes) {
        if (areOld()) {
            edition = images.texturesEdition();
            held = Map.of();
        }
        Map<Path, TextureImage> before = held;
        held = SceneImages.textures(
                scene,
                meshes,
                file -> Optional.ofNullable(before.get(file)).orElseGet(() -> read(file, scene, meshes)),
                images::warn);
        complaints.keySet().retainAll(held.keySet());
        return held;
    }

    /** Why textures are not shown. */
    Optional<String> complaint() {
        return Optional.of(String.join("; ", complaints.values())).filter(all -> !all.isEmpty());
    }

    private TextureImage read(Path file, Scene scene, SceneMeshes meshes) {
        complaints.remove(file);
        try {
            return meshes.embeddedImage(file)
                    .map(bytes -> TextureReader.read(file, bytes, images::warn))
                    .orElseGet(() -> images.texture(file, () -> isWanted(file, scene)));
        } catch (SkyException problem) {
            complaints.put(file, problem.getMessage());
        } catch (OutOfMemoryError _) {
            complaints.put(file, file + ": there is not enough memory for this texture");
        }
        return SceneImages.WHITE;
    }

    /** Whether the newest scene, or one of its meshes that have stayed the same, uses the texture. */
    private boolean isWanted(Path file, Scene scene) {
        return newest.get()
                .filter(now -> TexturePlaces.of(scene).containsKey(file)
                        ? TexturePlaces.of(now).containsKey(file)
                        : meshFiles(now).containsAll(meshFiles(scene)))
                .isPresent();
    }

    private static Set<Geometry> meshFiles(Scene scene) {
        return scene.meshes().stream().map(Mesh::geometry).collect(Collectors.toSet());
    }
}
