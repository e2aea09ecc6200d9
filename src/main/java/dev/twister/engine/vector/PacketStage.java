package dev.twister.engine.vector;

/** One step of one packet, behind an interface for the reason that {@link Stage} has. */
@FunctionalInterface
interface PacketStage {
    /** @param at the packet's place */
    void run(Tile tile, Drawing drawing, int at);
}
