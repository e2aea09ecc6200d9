package dev.twister.scene;

import java.nio.file.Path;

/** Where the triangles of a mesh come from. */
public sealed interface Geometry permits Geometry.OfFile, Shape, Triangles {
    /** A short name for people. */
    String name();

    /**
     * The triangles of a file.
     *
     * @param path OBJ, glTF, PLY or STL, already resolved against the scene file's folder
     */
    record OfFile(Path path) implements Geometry {
        @Override
        public String name() {
            return String.valueOf(path.getFileName());
        }

        @Override
        public String toString() {
            return path.toString();
        }
    }
}
