package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * The root's children that each beam of a packet may meet, with one beam per lane: the root often has fewer children
 * than the packet has beams. It calls no helpers; see {@code ShadowConics}.
 */
public final class RootChildren {
    private RootChildren() {}

    /**
     * Writes links to the children met, child by child, with the beams' numbers above. Requires a CPU that packs lanes.
     *
     * @param links room for children times beams, plus {@link Lanes#COUNT}
     * @param count number of beams
     * @return the number of links written
     */
    static int list(WideHierarchy hierarchy, PacketBeams beams, int count, int[] links) {
        float[] boxes = hierarchy.boxes;
        float[] f = beams.facts;
        IntVector sides = IntVector.fromArray(Lanes.INTS, beams.nearSides, 0);
        VectorMask<Float> fallsX =
                sides.and(PacketBeams.SIDE).compare(VectorOperators.NE, 0).cast(Lanes.FLOATS);
        VectorMask<Float> fallsY = sides.and(PacketBeams.SIDE << PacketBeams.SIDE_BITS)
                .compare(VectorOperators.NE, 0)
                .cast(Lanes.FLOATS);
        VectorMask<Float> fallsZ = sides.and(PacketBeams.SIDE << (2 * PacketBeams.SIDE_BITS))
                .compare(VectorOperators.NE, 0)
                .cast(Lanes.FLOATS);
        VectorMask<Integer> counts = VectorMask.fromLong(Lanes.INTS, Lanes.first(count));
        IntVector numbers = Lanes.numbers().lanewise(VectorOperators.LSHL, WideHierarchy.BEAM_SHIFT);
        int tail = 0;
        for (int child = 0; child < hierarchy.rootChildren; child++) {
            int at = WideHierarchy.FIRST + child;
            FloatVector lowX = FloatVector.broadcast(Lanes.FLOATS, boxes[at]);
            FloatVector lowY = FloatVector.broadcast(Lanes.FLOATS, boxes[at + Lanes.COUNT]);
            FloatVector lowZ = FloatVector.broadcast(Lanes.FLOATS, boxes[at + 2 * Lanes.COUNT]);
            FloatVector highX = FloatVector.broadcast(Lanes.FLOATS, boxes[at + 3 * Lanes.COUNT]);
            FloatVector highY = FloatVector.broadcast(Lanes.FLOATS, boxes[at + 4 * Lanes.COUNT]);
            FloatVector highZ = FloatVector.broadcast(Lanes.FLOATS, boxes[at + 5 * Lanes.COUNT]);
            FloatVector farX = highX.blend(lowX, fallsX);
            FloatVector farY = highY.blend(lowY, fallsY);
            FloatVector farZ = highZ.blend(lowZ, fallsZ);
            IntVector near = lowX.blend(highX, fallsX)
                    .mul(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.NEAR_SCALE))
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.NEAR_ADDITION))
                    .reinterpretAsInts();
            IntVector nearY = lowY.blend(highY, fallsY)
                    .mul(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.NEAR_SCALE + Lanes.COUNT))
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.NEAR_ADDITION + Lanes.COUNT))
                    .reinterpretAsInts();
            IntVector nearZ = lowZ.blend(highZ, fallsZ)
                    .mul(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.NEAR_SCALE + 2 * Lanes.COUNT))
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.NEAR_ADDITION + 2 * Lanes.COUNT))
                    .reinterpretAsInts();
            near = near.max(0)
                    .max(nearY.max(nearZ))
                    .max(farX.mul(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.SECOND_SCALE))
                            .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.SECOND_ADDITION))
                            .reinterpretAsInts())
                    .max(farY.mul(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.SECOND_SCALE + Lanes.COUNT))
                            .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.SECOND_ADDITION + Lanes.COUNT))
                            .reinterpretAsInts())
                    .max(farZ.mul(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.SECOND_SCALE + 2 * Lanes.COUNT))
                            .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.SECOND_ADDITION + 2 * Lanes.COUNT))
                            .reinterpretAsInts());
            IntVector far = farX.mul(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.FAR_SCALE))
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.FAR_ADDITION))
                    .reinterpretAsInts();
            IntVector nextY = farY.mul(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.FAR_SCALE + Lanes.COUNT))
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.FAR_ADDITION + Lanes.COUNT))
                    .reinterpretAsInts();
            IntVector nextZ = farZ.mul(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.FAR_SCALE + 2 * Lanes.COUNT))
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.FAR_ADDITION + 2 * Lanes.COUNT))
                    .reinterpretAsInts();
            far = far.min(FloatVector.fromArray(Lanes.FLOATS, f, PacketBeams.END)
                            .reinterpretAsInts())
                    .min(nextY.min(nextZ));
            VectorMask<Integer> met = near.compare(VectorOperators.LE, far).and(counts);
            numbers.or(hierarchy.links[at]).compress(met).intoArray(links, tail);
            tail += met.trueCount();
        }
        return tail;
    }
}
