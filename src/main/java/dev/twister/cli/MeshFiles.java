package dev.twister.cli;

import dev.twister.mesh.MeshReader;
import dev.twister.mesh.MeshStage;
import dev.twister.scene.Scene;
import dev.twister.sky.ShippedSky;
import java.io.PrintWriter;
import java.nio.file.Path;

/** Scenes around mesh files that commands are given. */
final class MeshFiles {
    private MeshFiles() {}

    /**
     * The scene to look at a mesh in.
     *
     * @param err told of what the file says and is not used
     * @throws dev.twister.mesh.MeshException where the file is not a mesh that can be read
     */
    static Scene stage(Path file, PrintWriter err) {
        Path mesh = file.toAbsolutePath().normalize();
        return MeshStage.of(
                mesh,
                MeshReader.read(mesh, MeshStage.SMOOTH_DEGREES, warning -> err.println("twister: warning: " + warning)),
                Home.skyboxes()
                        .resolve(ShippedSky.DAY.fileName())
                        .toAbsolutePath()
                        .normalize());
    }
}
