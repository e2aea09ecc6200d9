package dev.twister.cli;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshReader;
import dev.twister.mesh.MeshStage;
import dev.twister.scene.Scene;
import dev.twister.sky.ShippedSky;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.function.Consumer;

/** Scenes around mesh files that commands are given. */
final class MeshFiles {
    private MeshFiles() {}

    /**
     * The scene to look at a mesh in.
     *
     * @param images whether to read sky and textures too, only for what is to be said of them
     * @param err told of what the file says and is not used
     * @throws dev.twister.mesh.MeshException where the file is not a mesh that can be read
     */
    static Scene stage(Path file, boolean images, PrintWriter err) {
        Consumer<String> warnings = warning -> err.println("twister: warning: " + warning);
        Path mesh = file.toAbsolutePath().normalize();
        MeshFile content = MeshReader.read(mesh, MeshStage.SMOOTH_DEGREES, warnings);
        Scene scene = MeshStage.of(
                mesh,
                content,
                Home.skyboxes()
                        .resolve(ShippedSky.DAY.fileName())
                        .toAbsolutePath()
                        .normalize());
        if (images) {
            SceneImages.read(scene, SceneMeshes.of(scene, _ -> content), warnings);
        }
        return scene;
    }
}
