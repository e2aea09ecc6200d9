package dev.twister.gui.drawing;

import java.util.Optional;

/**
 * What the drawing thread has to say beside its pictures.
 *
 * @param opening the id of the engine that is being opened
 * @param engineFailure why the chosen engine does not draw
 * @param sceneFailure why the scene is not seen, or its sky is not
 */
public record DrawingStatus(Optional<String> opening, Optional<String> engineFailure, Optional<String> sceneFailure) {
    public static final DrawingStatus QUIET = new DrawingStatus(Optional.empty(), Optional.empty(), Optional.empty());
}
