package dev.twister.mesh.input;

import dev.twister.mesh.MeshException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.function.Function;

/** Files that a mesh file refers to; they must be in its folder or below. */
public final class PathsBeside {
    private PathsBeside() {}

    /**
     * Resolves a file name.
     *
     * @param file the referring file
     * @param name a relative path with slashes or backslashes
     * @param failure creates the exception for a problem
     */
    public static Path of(Path file, String name, Function<String, MeshException> failure) {
        String slashed = name.replace('\\', '/');
        boolean absolute = slashed.startsWith("/") || slashed.matches("[A-Za-z][A-Za-z0-9+.-]*:.*");
        boolean above = ("/" + slashed + "/").contains("/../");
        if (absolute || above || slashed.isBlank()) {
            throw failure.apply("the path " + QuotedText.text(name)
                    + " is refused; name a file in this file's folder or below by a relative path without '..'");
        }
        try {
            return file.resolveSibling(Path.of(slashed).normalize());
        } catch (InvalidPathException invalid) {
            throw failure.apply("the path " + QuotedText.text(name) + " is none that this system has");
        }
    }
}
