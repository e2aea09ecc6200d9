package dev.twister.cli;

import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import java.io.PrintWriter;
import java.nio.file.Path;

/** Reads panoramas for commands. */
final class SkyFiles {
    private SkyFiles() {}

    /**
     * Reads a panorama as {@link SkyboxReader#read} does.
     *
     * @param err told of what the file says and is not used
     */
    static Skybox read(Path file, PrintWriter err) {
        return SkyboxReader.read(file, warning -> err.println("twister: warning: " + warning));
    }
}
