package dev.twister.render;

import dev.twister.scene.Camera;
import java.util.function.DoubleFunction;

/**
 * What changes between the frames of a film.
 *
 * @param camera at a time in seconds
 * @param rate frames per second
 */
public record Movement(BodyMotion bodies, DoubleFunction<Camera> camera, double rate) {}
