package dev.twister.bench;

/**
 * What bodies that move cost before a frame can be drawn: means in milliseconds a frame.
 *
 * @param step of the physics
 * @param rebuild of the hierarchy over the spheres, with all else that a snapshot of the world takes
 */
public record MotionTimes(double step, double rebuild) {}
