package dev.twister.scene;

import java.nio.file.Files;
import java.nio.file.Path;

/** Reads scene files; {@code scenes/scene.schema.json} says what one holds. */
public final class SceneReader {
    private SceneReader() {}

    /**
     * Reads and checks a scene file, JSON in UTF-8 of at most 64 MiB.
     *
     * @return the scene, its skybox as an absolute path without {@code ..}
     * @throws SceneException if the file cannot be read, is not a valid scene, or names a skybox that is not there; the
     *     message is one line
     */
    public static Scene read(Path file) {
        SourceText source = SourceFile.read(file);
        return SceneDocument.parse(source, file.toAbsolutePath().resolveSibling(""), SceneReader::checkSkybox);
    }

    private static void checkSkybox(Place place, Path file) {
        if (Files.isDirectory(file)) {
            throw place.failure("names a folder, but must name a picture: " + Excerpt.ofPath(file.toString()));
        }
        if (!Files.isRegularFile(file)) {
            throw place.failure("names a file that is not there: " + Excerpt.ofPath(file.toString()));
        }
    }
}
