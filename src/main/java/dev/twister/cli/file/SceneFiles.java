package dev.twister.cli.file;

import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Finds the scene that an argument means: a file, or a shipped scene by its name. */
public final class SceneFiles {
    static final String ENDING = ".json";

    /** A scene that is read from standard input. */
    public static final Path STANDARD_INPUT = Path.of("-");

    private static final String SCHEMA_ENDING = ".schema.json";
    private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_-]+");

    private SceneFiles() {}

    /**
     * Reads a file that {@link #find} has found, or standard input.
     *
     * @throws SceneException if it is not a valid scene
     */
    public static Scene read(Path file) {
        return file.equals(STANDARD_INPUT)
                ? SceneReader.read(System.in, name(file), Path.of(""))
                : SceneReader.read(file);
    }

    /** The file's name for people. */
    public static String name(Path file) {
        return file.equals(STANDARD_INPUT) ? "standard input" : file.toString();
    }

    /** A file that is there wins over a shipped scene; a path that is neither is left to the reader to complain of. */
    public static Path find(String fileOrName) {
        if (fileOrName.isEmpty()) {
            throw new BadInputException("the scene's name is empty; give a scene file, or the name of a shipped scene");
        }
        Path file = path(fileOrName);
        if (file.equals(STANDARD_INPUT)) {
            return file;
        }
        if (Files.isRegularFile(file) || !NAME.matcher(fileOrName).matches()) {
            return file;
        }
        Path shipped = Home.scenes().resolve(fileOrName + ENDING);
        if (Files.isRegularFile(shipped)) {
            return shipped;
        }
        if (Files.exists(file)) {
            return file;
        }
        throw new BadInputException(
                "there is no file and no shipped scene called '" + fileOrName + "'; shipped are: " + shippedNames());
    }

    private static Path path(String text) {
        try {
            return new PathConverter().path(text);
        } catch (InvalidPathException problem) {
            throw new BadInputException("SCENE is not a valid file name: " + problem.getMessage());
        }
    }

    /**
     * The names of the shipped scenes, in the alphabet's order.
     *
     * @throws IOException where their folder cannot be read
     */
    public static List<String> shipped() throws IOException {
        try (Stream<Path> files = Files.list(Home.scenes())) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(ENDING) && !name.endsWith(SCHEMA_ENDING))
                    .map(name -> name.substring(0, name.length() - ENDING.length()))
                    .sorted()
                    .toList();
        }
    }

    private static String shippedNames() {
        try {
            return String.join(", ", shipped());
        } catch (IOException _) {
            return "none in " + Home.scenes().toAbsolutePath() + " (TWISTER_HOME names Twister's folder)";
        }
    }
}
