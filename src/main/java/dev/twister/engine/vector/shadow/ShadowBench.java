package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.crowd.Walks;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.shortcut.Hull;

/** One thread's tools for shadows. */
public final class ShadowBench {
    /** Where more are near, each point looks for its own. */
    static final int MOST_NEAR = 256;

    public final ShadowColumns columns = new ShadowColumns();

    /** The region between some points and the light. */
    final Hull hull = new Hull();

    final Walks walks;

    /** The spheres near a packet's lines to the light. */
    final SphereColumns near = new SphereColumns();

    /** Those of one point at a time. */
    final LoneCandidates lone = new LoneCandidates();

    final LeafCandidates leafCandidates = new LeafCandidates();

    /** With the walks of the same thread. */
    public ShadowBench(Walks walks) {
        this.walks = walks;
    }

    /** Makes room for a frame. */
    public void start(Drawing drawing) {
        columns.reserveBodies(drawing.input.bodyCount());
        near.reserveList(MOST_NEAR + Lanes.COUNT);
    }
}
