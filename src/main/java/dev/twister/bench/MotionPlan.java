package dev.twister.bench;

import dev.twister.scene.Scene;

/**
 * Bodies that move while frames are measured.
 *
 * @param scene of the measured world
 * @param startSeconds simulated before the first frame, 0 or more
 * @param secondsPerFrame simulated for each frame
 */
public record MotionPlan(Scene scene, double startSeconds, double secondsPerFrame) {}
