package dev.twister.engine.vector;

/**
 * All leaves that a beam may meet, found level by level: what is tested next does not depend on what was found last, so that
 * the CPU tests several nodes at a time.
 */
final class Leaves {
    /** The most that are found. */
    static final int MOST = 64;

    private static final int ROOM = 4 * MOST;

    /** The leaves' places among the children of all nodes. */
    final int[] places = new int[MOST];

    int count;

    /** Places of nodes and leaves met, in the order in which they are looked at. */
    private final int[] queue = new int[ROOM + Lanes.COUNT];

    private final float[] entries = new float[Lanes.COUNT];

    /**
     * Finds them; where a beam meets too many, a {@link Descent} that goes to the nearest first is better.
     *
     * @param most at most {@link #MOST}
     * @return whether there are at most so many
     */
    boolean find(WideHierarchy hierarchy, Beam beam, int most) {
        count = 0;
        int tail = append(hierarchy, beam, 0, 0);
        int head = 0;
        int room = 4 * most;
        while (head < tail && tail <= room && count < most) {
            int place = queue[head];
            head++;
            if (hierarchy.counts[place] == WideHierarchy.NODE) {
                tail = append(hierarchy, beam, hierarchy.links[place], tail);
            } else {
                places[count] = place;
                count++;
            }
        }
        return head == tail && tail <= room;
    }

    private int append(WideHierarchy hierarchy, Beam beam, int node, int tail) {
        long met = beam.meeting(hierarchy.boxes, node * WideHierarchy.BOX_STRIDE, entries);
        Lanes.pack(node * Lanes.COUNT, met, queue, tail);
        return tail + Long.bitCount(met);
    }
}
