package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.kernel.Layout;

/** Traversal stack of a beam in a {@link WideHierarchy}, with the nearest node on top. */
public final class BeamStack {
    private static final int ROOM = (Layout.MOST_ANCESTORS + 2) * Lanes.COUNT;

    /** Entry t of each child of the node tested last, from {@link Lanes#BORDER} on. */
    private final float[] childEntries = new float[Lanes.BORDER + Lanes.COUNT];

    /** Links on the stack. */
    private final int[] children = new int[ROOM];

    private final float[] entries = new float[ROOM];
    private int waiting;

    /** Starts at the root. */
    public void start(WideHierarchy hierarchy, Beam beam) {
        waiting = 0;
        open(hierarchy.boxes, hierarchy.links, beam, WideHierarchy.ROOT);
    }

    /** Starts at the entrance found for the whole tile. */
    public void start(EntryNodes entrance, Beam beam) {
        waiting = 0;
        open(entrance.boxes, entrance.links, beam, 0);
    }

    /** Pushes the children of a node that the beam may meet before its end, the nearest last. */
    private void open(float[] boxes, int[] links, Beam beam, int node) {
        long met = beam.meeting(boxes, WideHierarchy.FIRST + node * WideHierarchy.BOX_STRIDE, childEntries);
        int bottom = waiting;
        while (met != 0L) {
            int child = Long.numberOfTrailingZeros(met);
            met &= met - 1;
            float entry = childEntries[Lanes.BORDER + child];
            int place = waiting;
            while (place > bottom && entries[place - 1] < entry) {
                entries[place] = entries[place - 1];
                children[place] = children[place - 1];
                place--;
            }
            entries[place] = entry;
            children[place] = links[WideHierarchy.FIRST + node * Lanes.COUNT + child];
            waiting++;
        }
    }

    /**
     * Continues to the next leaf that the beam may meet before its end.
     *
     * @return a link to the leaf, or -1 if there is none
     */
    public int nextLeaf(WideHierarchy hierarchy, Beam beam) {
        int leaf = -1;
        while (leaf < 0 && waiting > 0) {
            waiting--;
            if (entries[waiting] <= beam.end) {
                int child = children[waiting];
                if (WideHierarchy.isLeaf(child)) {
                    leaf = child;
                } else {
                    open(hierarchy.boxes, hierarchy.links, beam, child);
                }
            }
        }
        return leaf;
    }
}
