package dev.twister.engine.vector;

import dev.twister.kernel.Layout;

/** What a walk through a {@link WideHierarchy} has still to visit, the nearest on top. */
final class Descent {
    private static final int ROOM = (Layout.MOST_ANCESTORS + 2) * Lanes.COUNT;

    /** Where a region may enter each child of the node tested last, and how wide it is there. */
    final float[] childEntries = new float[2 * Lanes.COUNT];

    private final int[] children = new int[ROOM];
    private final float[] entries = new float[ROOM];
    private int waiting;

    /** Starts with the root. */
    void start(Tile tile, Drawing drawing, Hull hull) {
        waiting = 0;
        open(tile, drawing, hull, 0, Float.POSITIVE_INFINITY);
    }

    /** Adds the node's children that the region may meet before {@code limit}, the nearest last. */
    private void open(Tile tile, Drawing drawing, Hull hull, int node, float limit) {
        long met = LaneSteps.run(LaneSteps.PASS_BOXES, tile, drawing, hull, 0, node);
        if (met != 0L) {
            met &= LaneSteps.run(LaneSteps.CROSS_BOXES, tile, drawing, hull, 0, node);
        }
        int bottom = waiting;
        while (met != 0L) {
            int child = Long.numberOfTrailingZeros(met);
            met &= met - 1;
            float entry = childEntries[child];
            if (entry <= limit) {
                int place = waiting;
                while (place > bottom && entries[place - 1] < entry) {
                    entries[place] = entries[place - 1];
                    children[place] = children[place - 1];
                    place--;
                }
                entries[place] = entry;
                children[place] = node * Lanes.COUNT + child;
                waiting++;
            }
        }
    }

    /**
     * Goes down to the next leaf that the region may enter before {@code limit}.
     *
     * @return its place among the children of all nodes, or -1 where there is none
     */
    int nextLeaf(Tile tile, Drawing drawing, Hull hull, float limit) {
        WideHierarchy hierarchy = drawing.hierarchy;
        int leaf = -1;
        while (leaf < 0 && waiting > 0) {
            waiting--;
            if (entries[waiting] <= limit) {
                int child = children[waiting];
                if (hierarchy.spheres[child] == WideHierarchy.NODE) {
                    open(tile, drawing, hull, hierarchy.links[child], limit);
                } else {
                    leaf = child;
                }
            }
        }
        return leaf;
    }
}
