package dev.twister.engine.vector;

import dev.twister.kernel.SoftShadow;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/**
 * In which of the leaves that {@link PacketLeaves} has found for some points there are spheres that may come between the point and
 * the light: most have none, and then nothing more is asked of them.
 */
final class LeafCandidates {
    /** Of each leaf among the links, which lanes of any of its blocks hold candidates. */
    private final long[] lanes = new long[PacketLeaves.ROOM + Lanes.COUNT];

    /** Finds them by {@link SoftShadow#judge}'s margins, and without its frame. */
    void find(WideHierarchy hierarchy, PacketBeams beams, PacketLeaves leaves) {
        float[] spheres = hierarchy.spheres.values;
        float[] f = beams.facts;
        int[] links = leaves.links;
        for (int k = leaves.first; k < leaves.end; k++) {
            int beam = links[k] >>> WideHierarchy.BEAM_SHIFT;
            int at = WideHierarchy.firstBlock(links[k]);
            float axisX = f[PacketBeams.DIRECTION + beam];
            float axisY = f[PacketBeams.DIRECTION + Lanes.COUNT + beam];
            float axisZ = f[PacketBeams.DIRECTION + 2 * Lanes.COUNT + beam];
            float distance = f[PacketBeams.LENGTH + beam];
            long found = 0L;
            for (int left = WideHierarchy.blocks(links[k]); left > 0; left--) {
                FloatVector x = FloatVector.fromArray(Lanes.FLOATS, spheres, at).sub(f[PacketBeams.ORIGIN + beam]);
                FloatVector y = FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.Y * Lanes.COUNT)
                        .sub(f[PacketBeams.ORIGIN + Lanes.COUNT + beam]);
                FloatVector z = FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.Z * Lanes.COUNT)
                        .sub(f[PacketBeams.ORIGIN + 2 * Lanes.COUNT + beam]);
                FloatVector radius =
                        FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.RADIUS * Lanes.COUNT);
                FloatVector along = x.mul(axisX).add(y.mul(axisY)).add(z.mul(axisZ));
                FloatVector acrossX = x.sub(along.mul(axisX));
                FloatVector acrossY = y.sub(along.mul(axisY));
                FloatVector acrossZ = z.sub(along.mul(axisZ));
                FloatVector across =
                        acrossX.mul(acrossX).add(acrossY.mul(acrossY)).add(acrossZ.mul(acrossZ));
                FloatVector reach = along.mul(f[PacketBeams.TANGENT + beam])
                        .add(radius.mul(f[PacketBeams.SECANT + beam]))
                        .mul(SoftShadow.RELATIVE_MARGIN)
                        .add(along.abs().add(radius).add(distance).mul(SoftShadow.ABSOLUTE_MARGIN));
                found |= along.add(radius)
                        .compare(VectorOperators.GT, 0f)
                        .and(along.sub(radius).compare(VectorOperators.LT, distance * SoftShadow.RELATIVE_MARGIN))
                        .and(reach.compare(VectorOperators.GT, 0f))
                        .and(across.compare(VectorOperators.LE, reach.mul(reach)))
                        .and(FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.BODY * Lanes.COUNT)
                                .compare(VectorOperators.NE, f[PacketBeams.OWN + beam]))
                        .toLong();
                at += SphereColumns.COLUMNS * Lanes.COUNT;
            }
            lanes[k] = found;
        }
    }

    /** Whether there are any in the leaf of that place among the links. */
    boolean areIn(int leaf) {
        return lanes[leaf] != 0L;
    }

    /** Whether there are any in leaves from that place on, to before the other. */
    boolean areIn(int from, int end) {
        long any = 0L;
        for (int leaf = from; leaf < end; leaf++) {
            any |= lanes[leaf];
        }
        return any != 0L;
    }
}
