package dev.twister.scene;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** Reads scene files; {@code scenes/scene.schema.json} says what one holds. */
public final class SceneReader {
    private SceneReader() {}

    /**
     * Reads and checks a scene file, JSON in UTF-8 of at most 64 MiB. Its skybox is looked for from the folder that the file
     * was named in, and, where the file is a link, from that of the file it leads to.
     *
     * @return the scene, its skybox as an absolute path without {@code ..}
     * @throws SceneException if the file cannot be read, is not a valid scene, or names a skybox that is not there; the
     *     message is one line
     */
    public static Scene read(Path file) {
        SourceText source = SourceFile.read(file);
        return SceneDocument.parse(source, (place, name) -> skybox(place, file, name));
    }

    /**
     * Reads a scene file as {@link #read} does, but for its skybox: another one takes its place, whether it is there or not.
     *
     * @throws SceneException if the file cannot be read or is not a valid scene; the message is one line
     */
    public static Scene readUnder(Path skybox, Path file) {
        return SceneDocument.parse(SourceFile.read(file), (_, _) -> skybox);
    }

    private static Path skybox(Place place, Path scene, Path name) {
        Path file = beside(scene.toAbsolutePath(), name);
        Path found = Stream.of(
                        file,
                        // A link to a scene may be anywhere; its sky is where the scene is.
                        beside(FilePaths.real(scene), name),
                        // As Windows goes by names, and as scenes were written in linked folders before.
                        scene.toAbsolutePath().resolveSibling(name).normalize())
                .filter(Files::exists)
                .findFirst()
                .orElse(file);
        check(place, found);
        return found;
    }

    private static Path beside(Path scene, Path name) {
        return FilePaths.walked(scene.resolveSibling(name));
    }

    private static void check(Place place, Path file) {
        if (Files.isDirectory(file)) {
            throw place.failure("names a folder, but must name a picture: " + Excerpt.ofPath(file.toString()));
        }
        if (!Files.isRegularFile(file)) {
            throw place.failure("names a file that is not there: " + Excerpt.ofPath(file.toString()));
        }
    }
}
