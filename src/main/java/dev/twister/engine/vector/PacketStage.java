package dev.twister.engine.vector;

/** One step of one packet, behind an interface for the reason that {@link Stage} has. */
@FunctionalInterface
interface PacketStage {
    /** Does the step for the packet at that place. */
    void run(Tile tile, Drawing drawing, int at);
}
