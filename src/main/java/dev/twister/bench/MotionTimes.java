package dev.twister.bench;

import java.util.List;

/**
 * What frames of bodies that move cost, in milliseconds.
 *
 * @param step of the physics, a mean
 * @param rebuild of the hierarchy over the spheres, with all else that a snapshot of the world takes, a mean
 * @param drawing of each frame, as they came: each is of bodies elsewhere
 */
public record MotionTimes(double step, double rebuild, List<Double> drawing) {
    public MotionTimes {
        drawing = List.copyOf(drawing);
    }
}
