package dev.twister.gui.files;

import java.nio.file.Path;
import java.util.Optional;

/** How the window names files. */
public final class FileNames {
    private FileNames() {}

    /** The last part of a path. */
    public static String name(Path file) {
        return Optional.ofNullable(file.getFileName()).map(Path::toString).orElse("the scene");
    }

    static Path absolute(Path file) {
        return file.toAbsolutePath().normalize();
    }
}
