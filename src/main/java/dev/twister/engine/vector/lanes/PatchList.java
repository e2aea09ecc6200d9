package dev.twister.engine.vector.lanes;

/** Packets that see a small patch of the sky, each with the range of texels that its lanes need. */
public final class PatchList {
    /** Places of the packets' first pixels; only the first {@link #count} entries of each array are valid. */
    public final int[] places;

    /** First column and row of each patch in the padded sky. */
    public final int[] left;

    public final int[] top;

    /** Width and height of each patch in texels; only {@code SkyPatches} uses them. */
    public final int[] columns;

    public final int[] rows;

    public int count;

    /** Allocates room for {@code most} packets. */
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
