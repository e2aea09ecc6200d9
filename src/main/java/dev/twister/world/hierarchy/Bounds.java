package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;

/** Bounding boxes of spheres or boxes and of their centers. */
final class Bounds {
    private static final float NOWHERE = Float.MAX_VALUE;

    /**
     * Margins relative to position and extent, well above the rounding of centers, sides and the kernel's box tests.
     */
    private static final float PLACE_MARGIN = 3.0e-7f;

    private static final float SIZE_MARGIN = 4.0e-6f;

    private final float[] low = new float[3];
    private final float[] high = new float[3];

    /** Smallest coordinates of centers. */
    private final float[] first = new float[3];

    /** Largest coordinates of centers. */
    private final float[] last = new float[3];

    /** Computes the boxes of spheres, given the places of the first and behind the last. */
    void holdSpheres(float[] floats, int from, int to) {
        hold(floats, from, to, Layout.SPHERE_STRIDE, false);
    }

    /** Computes the boxes of boxes, given by minimum x, y, z and maximum x, y, z; their midpoints are the centers. */
    void holdBoxes(float[] sides, int start, int end) {
        hold(sides, 6 * start, 6 * end, 6, true);
    }

    private void hold(float[] floats, int from, int to, int stride, boolean boxes) {
        float leastX = NOWHERE;
        float greatestX = -NOWHERE;
        float startX = NOWHERE;
        float endX = -NOWHERE;
        float leastY = NOWHERE;
        float greatestY = -NOWHERE;
        float startY = NOWHERE;
        float endY = -NOWHERE;
        float leastZ = NOWHERE;
        float greatestZ = -NOWHERE;
        float startZ = NOWHERE;
        float endZ = -NOWHERE;
        for (int at = from; at < to; at += stride) {
            float radius = floats[at + Layout.SPHERE_RADIUS];
            float lowX = boxes ? floats[at] : floats[at] - radius;
            float highX = boxes ? floats[at + 3] : floats[at] + radius;
            float x = boxes ? 0.5f * (lowX + highX) : floats[at];
            float lowY = boxes ? floats[at + 1] : floats[at + 1] - radius;
            float highY = boxes ? floats[at + 4] : floats[at + 1] + radius;
            float y = boxes ? 0.5f * (lowY + highY) : floats[at + 1];
            float lowZ = boxes ? floats[at + 2] : floats[at + 2] - radius;
            float highZ = boxes ? floats[at + 5] : floats[at + 2] + radius;
            float z = boxes ? 0.5f * (lowZ + highZ) : floats[at + 2];
            leastX = Math.min(leastX, lowX);
            greatestX = Math.max(greatestX, highX);
            startX = Math.min(startX, x);
            endX = Math.max(endX, x);
            leastY = Math.min(leastY, lowY);
            greatestY = Math.max(greatestY, highY);
            startY = Math.min(startY, y);
            endY = Math.max(endY, y);
            leastZ = Math.min(leastZ, lowZ);
            greatestZ = Math.max(greatestZ, highZ);
            startZ = Math.min(startZ, z);
            endZ = Math.max(endZ, z);
        }
        set(0, leastX, greatestX, startX, endX);
        set(1, leastY, greatestY, startY, endY);
        set(2, leastZ, greatestZ, startZ, endZ);
    }

    private void set(int axis, float least, float most, float start, float end) {
        low[axis] = least;
        high[axis] = most;
        first[axis] = start;
        last[axis] = end;
    }

    /** Midpoint of a low side and its high side. */
    static float middle(float[] sides, int at) {
        return 0.5f * (sides[at] + sides[at + 3]);
    }

    /** Axis along which the centers are spread farthest: 0 for x, 1 for y, 2 for z. */
    int longestAxis() {
        float x = last[0] - first[0];
        float y = last[1] - first[1];
        float z = last[2] - first[2];
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    /** Smallest coordinate of a center along an axis. */
    float first(int axis) {
        return first[axis];
    }

    /** Largest coordinate of a center along an axis. */
    float last(int axis) {
        return last[axis];
    }

    /** Whether the centers are so far apart that they can be divided. */
    boolean areApart() {
        int axis = longestAxis();
        return areApart(first(axis), last(axis));
    }

    /** Whether the range is wide enough to be divided into bins or cells. */
    static boolean areApart(float low, float high) {
        return high - low > 1e-6f * Math.max(Math.abs(low), Math.abs(high)) && high - low > 1e-30f;
    }

    /** Writes the box to a node. */
    void write(float[] nodes, int node) {
        for (int axis = 0; axis < 3; axis++) {
            float center = 0.5f * (low[axis] + high[axis]);
            float farther = Math.max(Math.abs(low[axis]), Math.abs(high[axis]));
            nodes[node + Layout.NODE_CENTER + axis] = center;
            nodes[node + Layout.NODE_HALF + axis] =
                    Math.max(high[axis] - center, center - low[axis]) + PLACE_MARGIN * farther;
        }
        int half = node + Layout.NODE_HALF;
        float margin = SIZE_MARGIN * (nodes[half] + nodes[half + 1] + nodes[half + 2]);
        nodes[half] += margin;
        nodes[half + 1] += margin;
        nodes[half + 2] += margin;
    }

    /** Writes the box as minimum x, y, z and maximum x, y, z. */
    void writeSides(float[] sides, int at) {
        System.arraycopy(low, 0, sides, at, 3);
        System.arraycopy(high, 0, sides, at + 3, 3);
    }
}
