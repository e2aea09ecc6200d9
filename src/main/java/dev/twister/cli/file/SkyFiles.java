package dev.twister.cli.file;

import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.function.Consumer;

/** Reads panoramas, textures and meshes for commands. */
public final class SkyFiles {
    private SkyFiles() {}

    /**
     * Reads a panorama as {@link SkyboxReader#read} does.
     *
     * @param err told of what the file says and is not used
     */
    public static Skybox read(Path file, PrintWriter err) {
        return SkyboxReader.read(file, warnings(err));
    }

    /**
     * The world of a scene, whose meshes and pictures are read as {@link SceneMeshes#read} and {@link SceneImages#read}
     * do.
     *
     * @param err told of what the files say and is not used
     */
    public static World world(Scene scene, PrintWriter err) {
        return world(scene, meshes(scene, err), err);
    }

    /** As above, with the meshes of the scene. */
    public static World world(Scene scene, SceneMeshes meshes, PrintWriter err) {
        return World.of(scene, SceneImages.read(scene, meshes, warnings(err)), meshes);
    }

    /**
     * A scene's meshes, read as {@link SceneMeshes#read} does.
     *
     * @param err told of what the files say and is not used
     */
    public static SceneMeshes meshes(Scene scene, PrintWriter err) {
        return SceneMeshes.read(scene, warnings(err));
    }

    /** Prints warnings. */
    public static Consumer<String> warnings(PrintWriter err) {
        return warning -> err.println("twister: warning: " + warning);
    }
}
