package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;

/** Where the triangles of a mesh come from. */
public sealed interface Geometry permits Geometry.OfFile, Shape, Triangles {
    /** A short name for people. */
    String name();

    /**
     * The triangles of a file.
     *
     * @param path OBJ, glTF, PLY or STL, already resolved against the scene file's folder
     * @param scene of a glTF file: the name or the number of the scene; empty for the file's default scene
     */
    record OfFile(Path path, String scene) implements Geometry {
        public OfFile {
            requireNonNull(path, "path");
            requireNonNull(scene, "scene");
        }

        /** The file's default scene. */
        public OfFile(Path path) {
            this(path, "");
        }

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
