package dev.twister.engine.vector.lanes;

/** Packets that look at a small patch of the sky, each with the texels that any of its lanes needs. */
public final class PatchList {
    /** The places of the packets' first pixels; only the first {@link #count} of each array hold. */
    public final int[] places = new int[Tile.SIZE / Lanes.COUNT];

    /** The patches' first columns and rows in the padded sky. */
    public final int[] left = new int[places.length];

    public final int[] top = new int[places.length];

    /** How many texels they are wide and high; only {@code SkyPatches} asks for it. */
    public final int[] columns = new int[places.length];

    public final int[] rows = new int[places.length];

    public int count;

    public void clear() {
        count = 0;
    }
}
