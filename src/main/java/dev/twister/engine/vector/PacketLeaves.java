package dev.twister.engine.vector;

import java.util.Arrays;

/**
 * The leaves that each of a packet's beams may meet, found level by level for all beams together: what is tested next does
 * not depend on what was found last, so that the CPU tests several nodes at a time.
 */
final class PacketLeaves {
    /** The most that are kept of one beam. */
    static final int MOST = 64;

    private static final int ROOM = 4096;

    /** What waits is a beam's number above a place among the children of all nodes, which are less than 2^26 for all scenes. */
    private static final int PLACE_BITS = 26;

    private static final int PLACE = (1 << PLACE_BITS) - 1;

    /** Of each beam: how many leaves it may meet; more than {@link #MOST} stand for any number. */
    final int[] counts = new int[Lanes.COUNT];

    /** Of each beam, {@link #MOST} places among the children of all nodes. */
    final int[] places = new int[Lanes.COUNT * MOST];

    private final int[] queue = new int[ROOM + Lanes.COUNT];

    /**
     * Finds them.
     *
     * @param wanted one bit a beam
     * @return whether there was room for all
     */
    boolean find(WideHierarchy hierarchy, PacketBeams beams, long wanted) {
        Arrays.fill(counts, 0);
        int tail = 0;
        for (long rest = wanted; rest != 0L; rest &= rest - 1) {
            tail = append(hierarchy, beams, Long.numberOfTrailingZeros(rest), 0, tail);
        }
        int head = 0;
        while (head < tail && tail <= ROOM) {
            int place = queue[head] & PLACE;
            int beam = queue[head] >>> PLACE_BITS;
            head++;
            if (hierarchy.counts[place] == WideHierarchy.NODE) {
                tail = append(hierarchy, beams, beam, hierarchy.links[place], tail);
            } else if (counts[beam] <= MOST) {
                keep(beam, place);
            }
        }
        return tail <= ROOM;
    }

    private void keep(int beam, int place) {
        int count = counts[beam];
        if (count < MOST) {
            places[beam * MOST + count] = place;
        }
        counts[beam] = count + 1;
    }

    private int append(WideHierarchy hierarchy, PacketBeams beams, int beam, int node, int tail) {
        long met = beams.meeting(hierarchy.boxes, node * WideHierarchy.BOX_STRIDE, beam);
        Lanes.pack(beam << PLACE_BITS | node * Lanes.COUNT, met, queue, tail);
        return tail + Long.bitCount(met);
    }
}
