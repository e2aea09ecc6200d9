package dev.twister.engine.vector;

import java.util.Arrays;

/** Index maps for gathers. */
final class VectorSteps {
    private VectorSteps() {}

    /** {@code 0, step, 2 * step, ...}, one a lane. */
    static int[] of(int step) {
        int[] steps = new int[Lanes.COUNT];
        Arrays.setAll(steps, lane -> lane * step);
        return steps;
    }
}
