package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.crowd.PacketBeams;
import dev.twister.engine.vector.crowd.PacketLeaves;
import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.kernel.Shadow;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/**
 * The leaves of {@link PacketLeaves} that contain a possible occluder of their beam's point. Most leaves contain none
 * and are dropped here.
 */
public final class LeafCandidates {
    /** Links to the leaves with possible occluders, with the beams' numbers. */
    final int[] links = new int[PacketLeaves.ROOM + Lanes.COUNT];

    int count;

    /** One bit per beam with possible occluders. */
    int shaded;

    /** Selects the leaves with the margins of {@link Shadow#judge}, without its frame. */
    void find(WideHierarchy hierarchy, PacketBeams beams, PacketLeaves leaves) {
        float[] spheres = hierarchy.spheres.values;
        float[] f = beams.facts;
        int[] from = leaves.links;
        int kept = 0;
        int any = 0;
        for (int k = leaves.first; k < leaves.end; k++) {
            int beam = from[k] >>> WideHierarchy.BEAM_SHIFT;
            int at = WideHierarchy.firstBlock(from[k]);
            float axisX = f[PacketBeams.DIRECTION + beam];
            float axisY = f[PacketBeams.DIRECTION + Lanes.COUNT + beam];
            float axisZ = f[PacketBeams.DIRECTION + 2 * Lanes.COUNT + beam];
            float distance = f[PacketBeams.LENGTH + beam];
            long found = 0L;
            for (int left = WideHierarchy.blocks(from[k]); left > 0; left--) {
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
                        .mul(Shadow.RELATIVE_MARGIN)
                        .add(along.abs().add(radius).add(distance).mul(Shadow.ABSOLUTE_MARGIN));
                found |= along.add(radius)
                        .compare(VectorOperators.GT, 0f)
                        .and(along.sub(radius).compare(VectorOperators.LT, distance * Shadow.RELATIVE_MARGIN))
                        .and(reach.compare(VectorOperators.GT, 0f))
                        .and(across.compare(VectorOperators.LE, reach.mul(reach)))
                        .and(FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.BODY * Lanes.COUNT)
                                .compare(VectorOperators.NE, f[PacketBeams.OWN + beam]))
                        .toLong();
                at += SphereColumns.COLUMNS * Lanes.COUNT;
            }
            links[kept] = from[k];
            int one = found != 0L ? 1 : 0;
            kept += one;
            any |= one << beam;
        }
        count = kept;
        shaded = any;
    }
}
