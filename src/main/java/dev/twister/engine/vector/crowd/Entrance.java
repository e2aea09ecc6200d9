package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;

/**
 * Where a tile's packets begin their walks instead of at the root of a {@link WideHierarchy}: the nodes or leaves of
 * one of its levels, the lowest with at most as many as there are lanes, that a beam about all packets may meet, as
 * children of one node.
 */
public final class Entrance {
    /** Of one node, as {@link WideHierarchy#boxes} has them. */
    final float[] boxes = new float[WideHierarchy.FIRST + WideHierarchy.BOX_STRIDE];

    /** Of one node, as {@link WideHierarchy#links} has them. */
    final int[] links = new int[WideHierarchy.FIRST + Lanes.COUNT];

    private final float[] entries = new float[Lanes.BORDER + Lanes.COUNT];
    private Level level = new Level();
    private Level below = new Level();

    /** What the beam meets of a level: links, and where in the hierarchy's boxes their low sides along x are. */
    private static final class Level {
        final int[] links = new int[Lanes.COUNT];
        final int[] places = new int[Lanes.COUNT];
        int count;
    }

    /**
     * Finds them.
     *
     * @return whether there are any
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

    /** Adds those below a node that the beam meets; returns whether there was room. */
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
