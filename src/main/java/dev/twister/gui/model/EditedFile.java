package dev.twister.gui.model;

import java.nio.file.Path;

/**
 * A scene's file as it was when it was opened or saved last.
 *
 * @param mark of its content then
 */
public record EditedFile(Path path, FileMark mark) {}
