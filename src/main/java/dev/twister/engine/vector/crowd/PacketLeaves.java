package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * The leaves that each beam of a packet may meet, found level by level for all beams together. The next test does not
 * depend on the last result, so the CPU overlaps the tests of several nodes. It calls no helpers; see
 * {@code ShadowConics}.
 */
public final class PacketLeaves {
    public static final int ROOM = 4096;

    /** Links, with the beam's number above {@link WideHierarchy#BEAM_SHIFT}: nodes, then leaves. */
    public final int[] links = new int[ROOM + Lanes.COUNT];

    /** Range of the leaves in {@link #links}: the first, and the place after the last. */
    public int first;

    public int end;

    /**
     * Finds the leaves.
     *
     * @param count number of beams
     * @return whether all links fit
     */
    public boolean find(WideHierarchy hierarchy, PacketBeams beams, int count) {
        if (Lanes.PACK && hierarchy.rootChildren < count) {
            end = RootChildren.list(hierarchy, beams, count, links);
        } else {
            for (int beam = 0; beam < count; beam++) {
                links[beam] = beam << WideHierarchy.BEAM_SHIFT;
            }
            end = count;
        }
        open(hierarchy, beams);
        return end <= ROOM;
    }

    /**
     * Appends the children that the beams meet until only leaves are left. Positive floats compare like their bits, and
     * the order of negative entries does not matter, so maxima are taken as ints, which skips the handling of NaN and
     * -0.
     */
    private void open(WideHierarchy hierarchy, PacketBeams beams) {
        float[] boxes = hierarchy.boxes;
        float[] f = beams.facts;
        int[] nearSides = beams.nearSides;
        int head = 0;
        int tail = end;
        while (head < tail && tail <= ROOM && !WideHierarchy.isLeaf(links[head])) {
            int beam = links[head] >>> WideHierarchy.BEAM_SHIFT;
            int node = WideHierarchy.node(links[head]);
            head++;
            int at = WideHierarchy.FIRST + node * WideHierarchy.BOX_STRIDE;
            int sides = nearSides[beam];
            int x = at + (sides & PacketBeams.SIDE);
            int y = at + Lanes.COUNT + (sides >>> PacketBeams.SIDE_BITS & PacketBeams.SIDE);
            int z = at + 2 * Lanes.COUNT + (sides >>> (2 * PacketBeams.SIDE_BITS) & PacketBeams.SIDE);
            FloatVector farX = FloatVector.fromArray(Lanes.FLOATS, boxes, 2 * at + PacketBeams.AXES - x);
            FloatVector farY =
                    FloatVector.fromArray(Lanes.FLOATS, boxes, 2 * (at + Lanes.COUNT) + PacketBeams.AXES - y);
            FloatVector farZ =
                    FloatVector.fromArray(Lanes.FLOATS, boxes, 2 * (at + 2 * Lanes.COUNT) + PacketBeams.AXES - z);
            IntVector near = FloatVector.fromArray(Lanes.FLOATS, boxes, x)
                    .mul(f[PacketBeams.NEAR_SCALE + beam])
                    .add(f[PacketBeams.NEAR_ADDITION + beam])
                    .reinterpretAsInts();
            IntVector nearY = FloatVector.fromArray(Lanes.FLOATS, boxes, y)
                    .mul(f[PacketBeams.NEAR_SCALE + Lanes.COUNT + beam])
                    .add(f[PacketBeams.NEAR_ADDITION + Lanes.COUNT + beam])
                    .reinterpretAsInts();
            IntVector nearZ = FloatVector.fromArray(Lanes.FLOATS, boxes, z)
                    .mul(f[PacketBeams.NEAR_SCALE + 2 * Lanes.COUNT + beam])
                    .add(f[PacketBeams.NEAR_ADDITION + 2 * Lanes.COUNT + beam])
                    .reinterpretAsInts();
            near = near.max(0).max(nearY.max(nearZ));
            if (sides < 0) {
                near = near.max(farX.mul(f[PacketBeams.SECOND_SCALE + beam])
                                .add(f[PacketBeams.SECOND_ADDITION + beam])
                                .reinterpretAsInts())
                        .max(farY.mul(f[PacketBeams.SECOND_SCALE + Lanes.COUNT + beam])
                                .add(f[PacketBeams.SECOND_ADDITION + Lanes.COUNT + beam])
                                .reinterpretAsInts())
                        .max(farZ.mul(f[PacketBeams.SECOND_SCALE + 2 * Lanes.COUNT + beam])
                                .add(f[PacketBeams.SECOND_ADDITION + 2 * Lanes.COUNT + beam])
                                .reinterpretAsInts());
            }
            IntVector far = farX.mul(f[PacketBeams.FAR_SCALE + beam])
                    .add(f[PacketBeams.FAR_ADDITION + beam])
                    .reinterpretAsInts();
            IntVector nextY = farY.mul(f[PacketBeams.FAR_SCALE + Lanes.COUNT + beam])
                    .add(f[PacketBeams.FAR_ADDITION + Lanes.COUNT + beam])
                    .reinterpretAsInts();
            IntVector nextZ = farZ.mul(f[PacketBeams.FAR_SCALE + 2 * Lanes.COUNT + beam])
                    .add(f[PacketBeams.FAR_ADDITION + 2 * Lanes.COUNT + beam])
                    .reinterpretAsInts();
            far = far.min(FloatVector.broadcast(Lanes.FLOATS, f[PacketBeams.END + beam])
                            .reinterpretAsInts())
                    .min(nextY.min(nextZ));
            VectorMask<Integer> met = near.compare(VectorOperators.LE, far);
            if (Lanes.PACK) {
                IntVector.fromArray(Lanes.INTS, hierarchy.links, WideHierarchy.FIRST + node * Lanes.COUNT)
                        .or(beam << WideHierarchy.BEAM_SHIFT)
                        .compress(met)
                        .intoArray(links, tail);
                tail += met.trueCount();
            } else {
                tail = keep(
                        hierarchy.links,
                        WideHierarchy.FIRST + node * Lanes.COUNT,
                        met.toLong(),
                        beam << WideHierarchy.BEAM_SHIFT,
                        tail);
            }
        }
        first = head;
        end = tail;
    }

    private int keep(int[] from, int at, long lanes, int beam, int to) {
        int place = to;
        for (long rest = lanes; rest != 0L; rest &= rest - 1) {
            links[place] = beam | from[at + Long.numberOfTrailingZeros(rest)];
            place++;
        }
        return place;
    }
}
