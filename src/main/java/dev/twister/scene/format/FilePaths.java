package dev.twister.scene.format;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * Paths as POSIX systems follow them: behind a symbolic link, {@code ..} is the folder above what the link leads to.
 * The same on Windows, so that a scene names its sky alike everywhere.
 */
final class FilePaths {
    private FilePaths() {}

    /**
     * An absolute path without {@code ..} to the same place, through the same links but where {@code ..} is behind one.
     */
    static Path walked(Path path) {
        Path absolute = path.toAbsolutePath();
        Path here = absolute.getRoot();
        for (Path name : absolute) {
            here = switch (name.toString()) {
                case "." -> here;
                case ".." -> above(here);
                default -> here.resolve(name);
            };
        }
        return here;
    }

    private static Path above(Path folder) {
        Path place = Files.isSymbolicLink(folder) ? real(folder) : folder;
        return Objects.requireNonNullElse(place.getParent(), place);
    }

    /** The path without links, as far as there is something; absolute. */
    static Path real(Path path) {
        Path absolute = path.toAbsolutePath();
        try {
            return absolute.toRealPath();
        } catch (IOException notThere) {
            Path parent = absolute.getParent();
            return parent == null ? absolute : real(parent).resolve(absolute.getFileName());
        }
    }
}
