package dev.twister.gui.files;

import java.nio.file.Path;
import java.util.Optional;

/** Asks for files; empty if canceled. Tests have their own. */
public interface FileChoice {
    /** An existing scene, mesh or panorama. */
    Optional<Path> toOpen(Path folder);

    /** A file for the scene. */
    Optional<Path> toSaveScene(Path suggested);

    /** An existing panorama. */
    Optional<Path> panorama(Path folder);

    /** An existing picture. */
    Optional<Path> picture(Path folder);

    /** An existing mesh. */
    Optional<Path> mesh(Path folder);

    /** An existing texture. */
    Optional<Path> texture(Path folder);

    /** A file for a picture, .png or .hdr. */
    Optional<Path> toSavePicture(Path suggested);

    /**
     * A file to render to.
     *
     * @param kind of file, for the dialog
     * @param ending of its name, with a dot
     */
    Optional<Path> toRender(Path suggested, String kind, String ending);

    /** A folder for a recording. */
    Optional<Path> folder(Path suggested);
}
