package dev.twister.gui.files;

import java.nio.file.Path;
import java.util.Optional;

/** Asks a person for files; empty where they think better of it. A test answers in their place. */
public interface FileChoice {
    /** A scene, a mesh or a panorama that is there. */
    Optional<Path> toOpen(Path folder);

    /** Where to save a scene. */
    Optional<Path> toSaveScene(Path suggested);

    /** A panorama that is there. */
    Optional<Path> panorama(Path folder);

    /** A mesh that is there. */
    Optional<Path> mesh(Path folder);

    /** A texture that is there. */
    Optional<Path> texture(Path folder);

    /** Where to save a picture, .png or .hdr. */
    Optional<Path> toSavePicture(Path suggested);

    /**
     * Where to render to.
     *
     * @param kind of file, for a person
     * @param ending of its name, with a dot
     */
    Optional<Path> toRender(Path suggested, String kind, String ending);

    /** A folder for a recording. */
    Optional<Path> folder(Path suggested);
}
