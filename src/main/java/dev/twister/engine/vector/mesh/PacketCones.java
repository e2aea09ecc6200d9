package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.kernel.Layout;

/** A packet's cones from its points to the light's disc, in the coordinates of a hierarchy. */
final class PacketCones {
    /** The points. */
    static final int POINT = Lanes.BORDER;

    /** {@code NodeBox.inverse} of the least components of a cone's directions, which end on the disc. */
    static final int LEAST = POINT + 3 * Lanes.COUNT;

    /** Likewise of the greatest components. */
    static final int GREATEST = POINT + 6 * Lanes.COUNT;

    /** {@code Float.MAX_VALUE} where the box's side for that column is where cones enter, minus it where they leave. */
    static final int LEAST_SIDE = POINT + 9 * Lanes.COUNT;

    static final int GREATEST_SIDE = POINT + 12 * Lanes.COUNT;

    private static final int LENGTH = POINT + 15 * Lanes.COUNT;

    final float[] values = new float[LENGTH];

    /** One bit per lane with a cone. */
    long lanes;

    /** Growth of each box, in the coordinates' unit. */
    float growth;

    /** Nodes laid out as in {@link Layout}, and the place of the root. */
    float[] boxes = {};

    int nodes;

    /** Places of the nodes to visit. */
    final int[] stack = new int[Layout.MOST_ANCESTORS + 2];

    int waiting;

    /** Prepares a traversal from the root. */
    void start(float[] newBoxes, int newNodes) {
        boxes = newBoxes;
        nodes = newNodes;
        stack[0] = newNodes;
        waiting = 1;
    }
}
