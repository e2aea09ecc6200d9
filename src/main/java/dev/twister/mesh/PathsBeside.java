package dev.twister.mesh;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.function.Function;

/** Files that a mesh file names: they lie in its folder, or in folders there. */
final class PathsBeside {
    private PathsBeside() {}

    /**
     * Where a named file is.
     *
     * @param file the one that names it
     * @param name with slashes or, as on Windows, backslashes
     * @param failure makes the exception for what is wrong
     */
    static Path of(Path file, String name, Function<String, MeshException> failure) {
        String slashed = name.replace('\\', '/');
        boolean absolute = slashed.startsWith("/") || slashed.matches("[A-Za-z][A-Za-z0-9+.-]*:.*");
        boolean above = ("/" + slashed + "/").contains("/../");
        if (absolute || above || slashed.isBlank()) {
            throw failure.apply("the path " + Shown.text(name)
                    + " is refused; name a file in this file's folder or below" + " by a relative path without '..'");
        }
        try {
            return file.resolveSibling(Path.of(slashed).normalize());
        } catch (InvalidPathException invalid) {
            throw failure.apply("the path " + Shown.text(name) + " is none that this system has");
        }
    }
}
