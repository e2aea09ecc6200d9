package dev.twister.engine.vector;

/** Packets that look at a small patch of the sky, each with the texels that any of its lanes needs. */
final class PatchList {
    /** The places of the packets' first pixels; only the first {@link #count} of each array hold. */
    final int[] places = new int[Tile.SIZE / Lanes.COUNT];

    /** The patches' first columns and rows in the padded sky. */
    final int[] left = new int[places.length];

    final int[] top = new int[places.length];

    /** How many texels they are wide and high; only {@link SkyPatches} asks for it. */
    final int[] columns = new int[places.length];

    final int[] rows = new int[places.length];

    int count;

    void clear() {
        count = 0;
    }
}
