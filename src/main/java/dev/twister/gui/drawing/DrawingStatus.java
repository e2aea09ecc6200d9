package dev.twister.gui.drawing;

import java.util.Optional;

/**
 * The state of the drawing thread.
 *
 * @param opening id of the engine that is being opened
 * @param engineFailure why the chosen engine does not draw
 * @param sceneFailure why the scene or its sky is not shown
 */
public record DrawingStatus(Optional<String> opening, Optional<String> engineFailure, Optional<String> sceneFailure) {
    public static final DrawingStatus QUIET = new DrawingStatus(Optional.empty(), Optional.empty(), Optional.empty());
}
