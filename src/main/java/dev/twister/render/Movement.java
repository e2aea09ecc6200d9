package dev.twister.render;

import dev.twister.scene.Scene;
import java.util.function.DoubleFunction;

/**
 * What changes between the frames of a film.
 *
 * @param scene of the order at a time in seconds; physics may move its spheres elsewhere
 * @param rate frames per second
 */
public record Movement(BodyMotion bodies, DoubleFunction<Scene> scene, double rate) {}
