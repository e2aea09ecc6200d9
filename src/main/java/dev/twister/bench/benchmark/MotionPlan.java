package dev.twister.bench.benchmark;

import dev.twister.scene.Scene;

/**
 * Motion of bodies during measurements.
 *
 * @param scene the measured world's scene
 * @param startSeconds simulated time before the first frame, at least 0
 * @param secondsPerFrame simulated time per frame
 */
public record MotionPlan(Scene scene, double startSeconds, double secondsPerFrame) {}
