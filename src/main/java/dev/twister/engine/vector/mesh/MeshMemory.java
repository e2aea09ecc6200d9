package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.shadow.ShadowMemory;
import dev.twister.kernel.Layout;

/** One thread's working memory for meshes. */
public final class MeshMemory {
    /** Traversals of the hierarchy over instances and of that over an instance's triangles. */
    final PacketWalk world = new PacketWalk();

    public final PacketWalk mesh = new PacketWalk();

    /** The triangles that may block the current packet's light. */
    final ConeTriangles listed = new ConeTriangles();

    final DiscColumns disc = new DiscColumns();

    /** Sum of the blocked parts of all samples per lane. */
    final float[] blocked = new float[Lanes.BORDER + Lanes.COUNT];

    /** What the bodies met so far transmit along the line to the current sample. */
    final float[] light = new float[Lanes.BORDER + Lanes.COUNT];

    /** The path of one ray, for the kernel. */
    final float[] path = new float[Layout.PATH_LENGTH];

    /** Columns of {@link CornerLanes}. */
    final float[] corners = new float[CornerLanes.LENGTH];

    final ShadowMemory shadows;

    /** Shares the shadow columns of the same thread. */
    public MeshMemory(ShadowMemory shadows) {
        this.shadows = shadows;
    }
}
