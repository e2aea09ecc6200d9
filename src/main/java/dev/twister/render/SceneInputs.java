package dev.twister.render;

import dev.twister.scene.Scene;
import dev.twister.scene.format.TexturePlaces;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Files that a scene is rendered from; no output may replace them. */
public final class SceneInputs {
    private SceneInputs() {}

    /** The scene's own file, its sky, textures and meshes. */
    public static List<Path> of(Path sceneFile, Scene scene) {
        return Stream.of(
                        Stream.of(sceneFile, scene.sky().file()),
                        TexturePlaces.of(scene).keySet().stream(),
                        scene.meshes().stream().flatMap(mesh -> mesh.file().stream()))
                .flatMap(files -> files)
                .toList();
    }

    /**
     * Whether writing a file would replace one of the inputs.
     *
     * @throws IOException if files cannot be compared
     */
    public static boolean areReplacedBy(Path file, List<Path> inputs) throws IOException {
        for (Path input : inputs) {
            if (Files.isRegularFile(input) && Files.exists(file) && Files.isSameFile(input, file)) {
                return true;
            }
        }
        return false;
    }
}
