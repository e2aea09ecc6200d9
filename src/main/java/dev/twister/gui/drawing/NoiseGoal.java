package dev.twister.gui.drawing;

import java.util.List;

/** The noise at which pictures stop gathering samples, relative to white. */
public final class NoiseGoal {
    /** All samples are gathered. */
    public static final double NONE = 0;

    /** What the window offers. */
    public static final List<Double> ALL = List.of(NONE, 0.05, 0.02, 0.01, 0.005, 0.002);

    private static final double PERCENT = 100;

    private NoiseGoal() {}

    /** The displayed text. */
    public static String label(double goal) {
        return goal == NONE ? "never" : goal * PERCENT + " %";
    }
}
