package dev.twister.gui;

import dev.twister.scene.Scene;
import java.nio.file.Path;

/**
 * A scene that was read and can be shown.
 *
 * @param file where it came from
 */
public record OpenedScene(Path file, Scene scene) {}
