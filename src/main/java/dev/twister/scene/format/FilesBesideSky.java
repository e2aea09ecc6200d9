package dev.twister.scene.format;

import dev.twister.scene.SceneException;
import java.nio.file.Path;
import java.util.function.Consumer;

/**
 * The files that a scene file names, all of which must be there but the skybox.
 *
 * @param found files that must be there
 * @param named files that need not be there
 * @param missing told why the skybox will not do
 */
record FilesBesideSky(NamedFiles found, NamedFiles named, Consumer<SceneException> missing) implements NamedFiles {
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
