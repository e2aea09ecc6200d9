package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.shadow.ShadowBench;

/** One thread's tools for meshes. */
public final class MeshBench {
    /** Through the hierarchy over the instances, and through that over an instance's triangles. */
    final PacketWalk world = new PacketWalk();

    final PacketWalk mesh = new PacketWalk();

    /** How many samples are blocked in each lane. */
    final float[] blocked = new float[Lanes.BORDER + Lanes.COUNT];

    /** 1 in the lanes whose lines are aimed at the sample. */
    final float[] aimed = new float[Lanes.BORDER + Lanes.COUNT];

    /** Columns of {@link CornerLanes}. */
    final float[] corners = new float[CornerLanes.LENGTH];

    final ShadowBench shadows;

    /** With the shadows of the same thread. */
    public MeshBench(ShadowBench shadows) {
        this.shadows = shadows;
    }
}
