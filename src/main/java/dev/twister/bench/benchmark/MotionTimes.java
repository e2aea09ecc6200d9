package dev.twister.bench.benchmark;

import java.util.List;

/**
 * Costs of frames with moving bodies, in milliseconds.
 *
 * @param step mean time of a physics step
 * @param rebuild mean time of a snapshot, mostly for rebuilding the hierarchy over the spheres
 * @param drawing time of each frame, in order, because each has other positions
 */
public record MotionTimes(double step, double rebuild, List<Double> drawing) {
    public MotionTimes {
        drawing = List.copyOf(drawing);
    }
}
