package dev.twister.scene.format;

import dev.twister.scene.SceneException;
import java.nio.file.Path;

/** The files that a scene file names: as their names stand there, and as they are found. */
interface NamedFiles {
    /** As they stand there. */
    NamedFiles UNRESOLVED = new NamedFiles() {
        @Override
        public Path find(Place place, Path name) {
            return name;
        }

        @Override
        public Path name(Path file) {
            return file;
        }
    };

    /**
     * The file of that name.
     *
     * @throws SceneException the place's failure, if the file will not do
     */
    Path find(Place place, Path name);

    /** What the scene file calls a file. */
    Path name(Path file);
}
