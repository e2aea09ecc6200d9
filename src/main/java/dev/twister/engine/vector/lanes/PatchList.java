package dev.twister.engine.vector.lanes;

/** Packets that look at a small patch of the sky, each with the texels that any of its lanes needs. */
public final class PatchList {
    /** The places of the packets' first pixels; only the first {@link #count} of each array hold. */
    public final int[] places;

    /** The patches' first columns and rows in the padded sky. */
    public final int[] left;

    public final int[] top;

    /** How many texels they are wide and high; only {@code SkyPatches} asks for it. */
    public final int[] columns;

    public final int[] rows;

    public int count;

    /** With room for that number. */
    PatchList(int most) {
        places = new int[most];
        left = new int[most];
        top = new int[most];
        columns = new int[most];
        rows = new int[most];
    }

    public void clear() {
        count = 0;
    }
}
