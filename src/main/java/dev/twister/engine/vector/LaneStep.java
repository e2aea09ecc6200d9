package dev.twister.engine.vector;

/** One step of a walk through the hierarchy, see {@link LaneSteps}. */
@FunctionalInterface
interface LaneStep {
    /**
     * Does the step.
     *
     * @param at the packet's place, or a pixel's, or a sample
     * @param item what is tested
     * @return bits, mostly one a lane; see the step
     */
    long run(Tile tile, Drawing drawing, int at, int item);
}
