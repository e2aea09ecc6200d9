package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;

/**
 * Common entry point for the traversals of a tile's packets instead of the root: the nodes or leaves of one level of a
 * {@link WideHierarchy} that a beam around all packets may meet, stored as the children of one node. It uses the lowest
 * level with no more of them than lanes.
 */
public final class EntryNodes {
    /** One node's boxes, laid out like {@link WideHierarchy#boxes}. */
    final float[] boxes = new float[WideHierarchy.FIRST + WideHierarchy.BOX_STRIDE];

    /** One node's links, laid out like {@link WideHierarchy#links}. */
    final int[] links = new int[WideHierarchy.FIRST + Lanes.COUNT];

    private final float[] entries = new float[Lanes.BORDER + Lanes.COUNT];
    private Level level = new Level();
    private Level below = new Level();

    /** Nodes or leaves of one level that the beam meets: links, and the places of their low x sides in the boxes. */
    private static final class Level {
        final int[] links = new int[Lanes.COUNT];
        final int[] places = new int[Lanes.COUNT];
        int count;
    }

    /**
     * Finds the entry nodes.
     *
     * @return whether the beam meets any
     */
    boolean find(WideHierarchy hierarchy, Beam beam) {
        below.count = 0;
        boolean goesDown = open(hierarchy, beam, WideHierarchy.ROOT);
        while (goesDown) {
            Level found = below;
            below = level;
            level = found;
            below.count = 0;
            goesDown = level.count > 0 && !WideHierarchy.isLeaf(level.links[0]);
            for (int k = 0; k < level.count && goesDown; k++) {
                goesDown = open(hierarchy, beam, level.links[k]);
            }
        }
        for (int child = 0; child < Lanes.COUNT; child++) {
            copy(hierarchy, child);
        }
        return level.count > 0;
    }

    /** Adds a node's children that the beam meets; returns false if they exceed the number of lanes. */
    private boolean open(WideHierarchy hierarchy, Beam beam, int node) {
        int at = WideHierarchy.FIRST + node * WideHierarchy.BOX_STRIDE;
        long met = beam.meeting(hierarchy.boxes, at, entries);
        boolean fits = below.count + Long.bitCount(met) <= Lanes.COUNT;
        for (long rest = fits ? met : 0L; rest != 0L; rest &= rest - 1) {
            int child = Long.numberOfTrailingZeros(rest);
            below.links[below.count] = hierarchy.links[WideHierarchy.FIRST + node * Lanes.COUNT + child];
            below.places[below.count] = at + child;
            below.count++;
        }
        return fits;
    }

    private void copy(WideHierarchy hierarchy, int child) {
        int to = WideHierarchy.FIRST + child;
        boolean exists = child < level.count;
        links[to] = exists ? level.links[child] : WideHierarchy.ROOT;
        for (int axis = 0; axis < 3; axis++) {
            int low = axis * Lanes.COUNT;
            int high = low + 3 * Lanes.COUNT;
            boxes[to + low] = exists ? hierarchy.boxes[level.places[child] + low] : WideHierarchy.INSIDE_OUT;
            boxes[to + high] = exists ? hierarchy.boxes[level.places[child] + high] : -WideHierarchy.INSIDE_OUT;
        }
    }
}
