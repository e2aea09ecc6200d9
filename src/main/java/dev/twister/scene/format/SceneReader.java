package dev.twister.scene.format;

import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.json.JsonPath;
import dev.twister.scene.format.json.SourceFile;
import dev.twister.scene.format.json.SourceText;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.function.Consumer;

/** Reads scene files; {@code scenes/scene.schema.json} says what one holds. */
public final class SceneReader {
    private SceneReader() {}

    /**
     * Reads and checks a scene file, JSON in UTF-8 of at most 64 MiB. Its skybox and textures are looked for from the
     * folder that the file was named in, and, where the file is a link, from that of the file it leads to.
     *
     * @return the scene, its files as absolute paths without {@code ..}
     * @throws SceneException if the file cannot be read, is not a valid scene, or names a file that is not there; the
     *     message is one line
     */
    public static Scene read(Path file) {
        SourceText source = SourceFile.read(file);
        return SceneDocument.parse(source, beside(file, true));
    }

    /**
     * Reads a scene file as {@link #read(Path)} does; its skybox need not be there.
     *
     * @param skyProblem told what {@code read} would throw if only the skybox is missing
     * @throws SceneException as {@code read}, for all other reasons
     */
    public static Scene read(Path file, Consumer<SceneException> skyProblem) {
        NamedFiles files = new FilesBesideSky(beside(file, true), beside(file, false), skyProblem);
        return SceneDocument.parse(SourceFile.read(file), files);
    }

    /**
     * Reads a scene file as {@link #read(Path)} does, but for its skybox: another one takes its place, whether it is
     * there or not.
     *
     * @throws SceneException if the file cannot be read or is not a valid scene; the message is one line
     */
    public static Scene readUnder(Path skybox, Path file) {
        Scene scene = SceneDocument.parse(SourceFile.read(file), new FilesUnderSky(skybox, beside(file, true)));
        return scene.withSky(scene.sky().withFile(skybox));
    }

    /**
     * Reads a scene file as {@link #read(Path)} does; its skybox and textures need not be there.
     *
     * @throws SceneException if the file cannot be read or is not a valid scene; the message is one line
     */
    public static Scene readWithoutPictures(Path file) {
        return SceneDocument.parse(SourceFile.read(file), beside(file, false));
    }

    /**
     * Reads a scene that is in no file, as {@link #read(Path)} does.
     *
     * @param in read to its end, and left open
     * @param name what messages begin with
     * @param folder in which its skybox and textures are looked for
     * @throws SceneException as {@link #read(Path)}
     */
    public static Scene read(InputStream in, String name, Path folder) {
        Path place = folder.resolve(name);
        return SceneDocument.parse(SourceFile.read(in, name), new FilesBeside(place, place, true));
    }

    private static NamedFiles beside(Path file, boolean needed) {
        return new FilesBeside(file, FilePaths.real(file), needed);
    }

    /**
     * The files that a scene file names, all of which must be there but the skybox.
     *
     * @param found files that must be there
     * @param named files that need not be there
     * @param missing told why the skybox will not do
     */
    private record FilesBesideSky(NamedFiles found, NamedFiles named, Consumer<SceneException> missing)
            implements NamedFiles {
        @Override
        public Path find(Place place, Path name) {
            if (!place.path().equals(FilesUnderSky.PLACE)) {
                return found.find(place, name);
            }
            try {
                return found.find(place, name);
            } catch (SceneException problem) {
                missing.accept(problem);
                return named.find(place, name);
            }
        }

        @Override
        public Path name(Path file) {
            return found.name(file);
        }
    }

    /**
     * The files that a scene file names, but for its skybox.
     *
     * @param skybox takes the place of the scene's own; need not be there
     */
    private record FilesUnderSky(Path skybox, NamedFiles others) implements NamedFiles {
        static final JsonPath PLACE = new JsonPath.Field(new JsonPath.Root(), SceneFormat.SKYBOX);

        @Override
        public Path find(Place place, Path name) {
            return place.path().equals(PLACE) ? skybox : others.find(place, name);
        }

        @Override
        public Path name(Path file) {
            return others.name(file);
        }
    }
}
