package dev.twister.scene.format;

import dev.twister.scene.format.json.JsonPath;
import java.nio.file.Path;

/**
 * The files that a scene file names, but for its skybox.
 *
 * @param skybox takes the place of the scene's own; need not be there
 */
record FilesUnderSky(Path skybox, NamedFiles others) implements NamedFiles {
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
