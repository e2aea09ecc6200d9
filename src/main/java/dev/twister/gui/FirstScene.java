package dev.twister.gui;

import dev.twister.gui.studio.OpenedScene;
import java.nio.file.Path;
import java.util.Optional;

/**
 * What the window starts with.
 *
 * @param opened shown first
 * @param asked whether the user named it, so that it is listed among recent scenes
 * @param toOpen a file that could not be read before: the window opens it and tells what is wrong with it
 */
public record FirstScene(OpenedScene opened, boolean asked, Optional<Path> toOpen) {
    /** A scene that nobody named. */
    public static FirstScene of(OpenedScene opened) {
        return new FirstScene(opened, false, Optional.empty());
    }
}
