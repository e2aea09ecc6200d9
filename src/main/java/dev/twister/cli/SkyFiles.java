package dev.twister.cli;

import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.SceneImages;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.stream.Stream;

/** Reads panoramas and textures for commands. */
final class SkyFiles {
    private SkyFiles() {}

    /**
     * Reads a panorama as {@link SkyboxReader#read} does.
     *
     * @param err told of what the file says and is not used
     */
    static Skybox read(Path file, PrintWriter err) {
        return SkyboxReader.read(file, warnings(err));
    }

    /**
     * Reads a scene's pictures as {@link SceneImages#read} does.
     *
     * @param err told of what the files say and is not used
     */
    static SceneImages readAll(Scene scene, PrintWriter err) {
        return SceneImages.read(scene, warnings(err));
    }

    /** The files that a scene is drawn from. */
    static Path[] inputs(Path sceneFile, Scene scene) {
        return Stream.concat(Stream.of(sceneFile, scene.skybox()), scene.textures().keySet().stream())
                .toArray(Path[]::new);
    }

    private static Consumer<String> warnings(PrintWriter err) {
        return warning -> err.println("twister: warning: " + warning);
    }
}
