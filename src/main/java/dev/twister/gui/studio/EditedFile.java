package dev.twister.gui.studio;

import java.nio.file.Path;

/**
 * A scene's file as it was when it was opened or saved last.
 *
 * @param mark of its content then
 */
public record EditedFile(Path path, FileMark mark) {
    /** Whether to write there replaces what another program has written since; reads the file. */
    public boolean isOverwrittenBy(Path target) {
        if (!absolute(target).equals(absolute(path))) {
            return false;
        }
        FileMark now = FileMark.of(path);
        return !now.equals(FileMark.NONE) && !now.equals(mark);
    }

    private static Path absolute(Path file) {
        return file.toAbsolutePath().normalize();
    }
}
