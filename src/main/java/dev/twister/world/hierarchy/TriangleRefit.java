package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;

/** Fits the hierarchy over triangles to other places of theirs. */
public final class TriangleRefit {
    private static final int SIDES = 6;

    private TriangleRefit() {}

    /**
     * Writes the boxes of all nodes.
     *
     * @param floats the nodes, children after their parents, then the triangles, see {@link Layout}
     * @return the sum of the boxes' areas as a part of the root's, relative to what it was before; not a number where a
     *     root has no area
     */
    public static double fit(float[] floats, int nodes) {
        int triangles = Layout.NODE_STRIDE * nodes;
        double rootBefore = area(floats, 0);
        double sumBefore = 0;
        double sumAfter = 0;
        float[] sides = new float[SIDES * nodes];
        Bounds bounds = new Bounds();
        for (int node = nodes - 1; node >= 0; node--) {
            int at = Layout.NODE_STRIDE * node;
            int link = (int) floats[at + Layout.NODE_LINK];
            int count = (int) floats[at + Layout.NODE_SPHERES];
            if (count < 0) {
                join(sides, SIDES * link, SIDES * node);
            } else {
                hold(floats, triangles + Layout.TRIANGLE_STRIDE * link, count, sides, SIDES * node);
            }
            sumBefore += area(floats, at);
            bounds.holdBoxes(sides, node, node + 1);
            bounds.write(floats, at);
            sumAfter += area(floats, at);
        }
        return sumAfter / area(floats, 0) * rootBefore / sumBefore;
    }

    /** The box around two neighboring boxes. */
    private static void join(float[] sides, int children, int to) {
        for (int axis = 0; axis < 3; axis++) {
            sides[to + axis] = Math.min(sides[children + axis], sides[children + SIDES + axis]);
            sides[to + 3 + axis] = Math.max(sides[children + 3 + axis], sides[children + SIDES + 3 + axis]);
        }
    }

    /** The box around triangles. */
    private static void hold(float[] floats, int first, int count, float[] sides, int to) {
        for (int axis = 0; axis < 3; axis++) {
            float low = Float.MAX_VALUE;
            float high = -Float.MAX_VALUE;
            for (int triangle = 0; triangle < count; triangle++) {
                int at = first + Layout.TRIANGLE_STRIDE * triangle + axis;
                low = Math.min(low, Math.min(floats[at], Math.min(floats[at + 3], floats[at + 6])));
                high = Math.max(high, Math.max(floats[at], Math.max(floats[at + 3], floats[at + 6])));
            }
            sides[to + axis] = low;
            sides[to + 3 + axis] = high;
        }
    }

    /** Relative surface area of a node's box. */
    private static double area(float[] floats, int node) {
        double x = floats[node + Layout.NODE_HALF];
        double y = floats[node + Layout.NODE_HALF + 1];
        double z = floats[node + Layout.NODE_HALF + 2];
        return x * y + y * z + z * x;
    }
}
