package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.crowd.TraversalMemory;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.shortcut.BoundingCone;

/** One thread's working memory for shadows. */
public final class ShadowMemory {
    /** With more spheres near a packet, each point traverses the hierarchy by itself. */
    static final int MOST_NEAR = 256;

    public final ShadowColumns columns = new ShadowColumns();

    /** The region between some points and the light. */
    final BoundingCone hull = new BoundingCone();

    final TraversalMemory walks;

    /** Spheres near a packet's lines to the light. */
    final SphereColumns near = new SphereColumns();

    /** Candidates of a single point. */
    final PointCandidates lone = new PointCandidates();

    final LeafCandidates leafCandidates = new LeafCandidates();

    /** Shares the traversals of the same thread. */
    public ShadowMemory(TraversalMemory walks) {
        this.walks = walks;
    }

    /** Allocates room for a frame. */
    public void start(Drawing drawing) {
        columns.reserveBodies(drawing.input.bodyCount());
        near.reserveList(MOST_NEAR + Lanes.COUNT);
    }
}
