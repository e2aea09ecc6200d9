package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;

/**
 * All leaves that a beam may meet, found level by level: what is tested next does not depend on what was found last, so
 * that the CPU tests several nodes at a time.
 */
public final class Leaves {
    private static final int ROOM = 1024;

    /**
     * So many leaves a beam is thought to meet at least below a node that it meets, before any of them is looked at.
     */
    private static final int LEAVES_A_NODE = 3;

    /** Links to nodes and leaves met, in the order in which they are looked at. */
    public final int[] links = new int[ROOM + Lanes.COUNT];

    /** Where the leaves begin among the links, and the place behind the last. */
    public int first;

    public int end;

    private final float[] entries = new float[Lanes.BORDER + Lanes.COUNT];

    /**
     * Finds them; where a beam meets too many, a {@link Descent} that goes to the nearest first is better.
     *
     * @param most at most {@value #ROOM}
     * @return whether there are at most that many
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
