package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.kernel.Layout;

/** A packet's rays in the coordinates of a hierarchy, and what of it they have still to visit. */
final class PacketWalk {
    /** The ray: where it starts, its direction of any length, and {@code NodeBox.inverse} of that. */
    static final int ORIGIN = Lanes.BORDER;

    static final int DIRECTION = ORIGIN + 3 * Lanes.COUNT;
    static final int INVERSE = ORIGIN + 6 * Lanes.COUNT;

    /** How many lengths of the direction matter; less than 0 in lanes that take no part. */
    static final int END = ORIGIN + 9 * Lanes.COUNT;

    /** As {@code Triangle.distance} takes them: the longest axis, the origin along the axes, and the shear. */
    static final int AXIS = ORIGIN + 10 * Lanes.COUNT;

    static final int FIRST = ORIGIN + 11 * Lanes.COUNT;
    static final int SECOND = ORIGIN + 12 * Lanes.COUNT;
    static final int THIRD = ORIGIN + 13 * Lanes.COUNT;
    static final int SHEAR_FIRST = ORIGIN + 14 * Lanes.COUNT;
    static final int SHEAR_SECOND = ORIGIN + 15 * Lanes.COUNT;
    static final int LONGEST_INVERSE = ORIGIN + 16 * Lanes.COUNT;

    /** The triangle that the ray leaves. */
    static final int IGNORED = ORIGIN + 17 * Lanes.COUNT;

    /**
     * Of the triangle looked at last: the areas opposite its corners, and how deep those are; or, of each ray's
     * triangle, the two sheared coordinates of its corners.
     */
    static final int AREA_A = ORIGIN + 18 * Lanes.COUNT;

    static final int AREA_B = ORIGIN + 19 * Lanes.COUNT;
    static final int AREA_C = ORIGIN + 20 * Lanes.COUNT;
    static final int DEPTH_A = ORIGIN + 21 * Lanes.COUNT;
    static final int DEPTH_B = ORIGIN + 22 * Lanes.COUNT;
    static final int DEPTH_C = ORIGIN + 23 * Lanes.COUNT;

    /** The origin times the direction's inverse, less than 0 where that is above: added to a side times the inverse. */
    static final int BEHIND = ORIGIN + 24 * Lanes.COUNT;

    private static final int LENGTH = ORIGIN + 27 * Lanes.COUNT;

    final float[] rays = new float[LENGTH];

    /** Nodes as {@link Layout} has them, and where the first of them is. */
    float[] boxes = {};

    int nodes;

    /** What each box is grown by, in the coordinates' unit. */
    float growth;

    /** Along each axis, 1 where rays come to a box's low side first, -1 where to its high one. */
    final float[] side = new float[3];

    /** Whether rays differ in that. */
    boolean mixed;

    /** Where nodes are that are to be visited. */
    final int[] stack = new int[Layout.MOST_ANCESTORS + 2];

    /** The bits of how many lengths of the direction lie before each of them, at the least. */
    final int[] entries = new int[Layout.MOST_ANCESTORS + 2];

    int waiting;

    /** The root as long as it has not been looked at, then {@link Layout#NO_NODE}. */
    int start;

    /** A direction that some ray has: of two nodes, the one that it comes to first is visited first. */
    float towardsX;

    float towardsY;
    float towardsZ;

    /** Prepares for a walk from the root. */
    void start(float[] newBoxes, int newNodes) {
        boxes = newBoxes;
        nodes = newNodes;
        start = newNodes;
        waiting = 0;
    }

    /** Goes the way of the ray of that lane. */
    void follow(int lane) {
        towardsX = rays[DIRECTION + lane];
        towardsY = rays[DIRECTION + Lanes.COUNT + lane];
        towardsZ = rays[DIRECTION + 2 * Lanes.COUNT + lane];
    }
}
