package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.kernel.Layout;

/** A packet's rays in the coordinates of a hierarchy, and their traversal stack. */
final class PacketWalk {
    /** The ray: origin, direction of any length, and {@code NodeBox.inverse} of the direction. */
    static final int ORIGIN = Lanes.BORDER;

    static final int DIRECTION = ORIGIN + 3 * Lanes.COUNT;
    static final int INVERSE = ORIGIN + 6 * Lanes.COUNT;

    /** End of the ray in lengths of the direction; negative in inactive lanes. */
    static final int END = ORIGIN + 9 * Lanes.COUNT;

    /** Inputs of {@code Triangle.distance}: dominant axis, origin along the permuted axes, and shear. */
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
     * Of the current triangle: the areas opposite its corners, and the corners' depths. In {@link CornerLanes}: the
     * sheared coordinates of the corners of each ray's triangle.
     */
    static final int AREA_A = ORIGIN + 18 * Lanes.COUNT;

    static final int AREA_B = ORIGIN + 19 * Lanes.COUNT;
    static final int AREA_C = ORIGIN + 20 * Lanes.COUNT;
    static final int DEPTH_A = ORIGIN + 21 * Lanes.COUNT;
    static final int DEPTH_B = ORIGIN + 22 * Lanes.COUNT;
    static final int DEPTH_C = ORIGIN + 23 * Lanes.COUNT;

    /** Minus the origin times the inverse direction: the addition in the slab test. */
    static final int BEHIND = ORIGIN + 24 * Lanes.COUNT;

    /** Distance of the current triangle, in lanes that meet it at the ray's end. */
    static final int MET = ORIGIN + 27 * Lanes.COUNT;

    /** {@link Layout#MESH_REACH} of each ray. */
    static final int REACH = ORIGIN + 28 * Lanes.COUNT;

    private static final int LENGTH = ORIGIN + 29 * Lanes.COUNT;

    final float[] rays = new float[LENGTH];

    /** Nodes laid out as in {@link Layout}, and the place of the root. */
    float[] boxes = {};

    int nodes;

    /** Growth of each box, in the coordinates' unit. */
    float growth;

    /** Per axis: 1 where rays meet a box's low side first, -1 where they meet its high side first. */
    final float[] side = new float[3];

    /** Whether that differs between rays. */
    boolean mixed;

    /** Places of the nodes to visit. */
    final int[] stack = new int[Layout.MOST_ANCESTORS + 2];

    /** Per node on the stack, the bits of its smallest entry among the rays, in lengths of the direction. */
    final int[] entries = new int[Layout.MOST_ANCESTORS + 2];

    int waiting;

    /** The root until it has been visited, then {@link Layout#NO_NODE}. */
    int start;

    /** One bit per axis that is dominant for any ray. */
    int axes;

    /** The current leaf's triangles: number of the first one, number after the last one, and place of number 0. */
    int from;

    int end;
    int triangles;

    /** The direction of one ray, which decides which of two children is visited first. */
    float towardsX;

    float towardsY;
    float towardsZ;

    /** Prepares a traversal from the root. */
    void start(float[] newBoxes, int newNodes) {
        boxes = newBoxes;
        nodes = newNodes;
        start = newNodes;
        waiting = 0;
    }

    /** Opens a leaf of a mesh. */
    void open(int leaf) {
        from = (int) boxes[leaf + Layout.NODE_LINK];
        end = from + (int) boxes[leaf + Layout.NODE_SPHERES];
    }

    /** Opens a leaf with a small mesh, see {@link Layout#SMALL_INSTANCE}; returns the mesh's place. */
    int openSmall(int leaf) {
        int small = nodes + (int) boxes[leaf + Layout.NODE_LINK];
        from = 0;
        end = (int) boxes[leaf + Layout.NODE_SPHERES];
        triangles = small + Layout.SMALL_TRIANGLES;
        return small;
    }

    /** Uses the ray of a lane for the order of the traversal. */
    void follow(int lane) {
        towardsX = rays[DIRECTION + lane];
        towardsY = rays[DIRECTION + Lanes.COUNT + lane];
        towardsZ = rays[DIRECTION + 2 * Lanes.COUNT + lane];
    }
}
