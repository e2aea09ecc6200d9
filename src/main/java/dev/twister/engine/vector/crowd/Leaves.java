package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;

/**
 * All leaves that a beam may meet, found level by level. The next test does not depend on the last result, so the CPU
 * overlaps the tests of several nodes.
 */
public final class Leaves {
    private static final int ROOM = 1024;

    /** Assumed minimum of leaves met per node, before any leaf is tested. */
    private static final int LEAVES_A_NODE = 3;

    /** Links to the nodes and leaves met, in the order of testing. */
    public final int[] links = new int[ROOM + Lanes.COUNT];

    /** Range of the leaves in {@link #links}: the first, and the place after the last. */
    public int first;

    public int end;

    private final float[] entries = new float[Lanes.BORDER + Lanes.COUNT];

    /**
     * Finds the leaves. For beams that meet many leaves, a {@link BeamStack} to the nearest first is faster.
     *
     * @param most largest accepted number of leaves, at most {@value #ROOM}
     * @return whether the number of leaves is within {@code most}
     */
    public boolean find(WideHierarchy hierarchy, Beam beam, int most) {
        links[0] = WideHierarchy.ROOT;
        int head = 0;
        int tail = 1;
        while (head < tail && tail - head <= most && !hierarchy.isAboveLeaves(links[head])) {
            tail = append(hierarchy, beam, links[head], tail);
            head++;
        }
        first = tail;
        boolean few = first - head <= most / LEAVES_A_NODE;
        while (few && head < first) {
            tail = append(hierarchy, beam, links[head], tail);
            head++;
            few = tail - first <= most;
        }
        end = tail;
        return few;
    }

    private int append(WideHierarchy hierarchy, Beam beam, int node, int tail) {
        long met = beam.meeting(hierarchy.boxes, WideHierarchy.FIRST + node * WideHierarchy.BOX_STRIDE, entries);
        Lanes.pack(hierarchy.links, WideHierarchy.FIRST + node * Lanes.COUNT, met, links, tail);
        return tail + Long.bitCount(met);
    }
}
