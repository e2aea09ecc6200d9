package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;

/** Bounding boxes of spheres and of their centers. */
final class Bounds {
    private static final float NOWHERE = Float.MAX_VALUE;

    /**
     * Margins relative to position and extent, well above the rounding of centers, sides and the kernel's box tests.
     */
    private static final float PLACE_MARGIN = 3.0e-7f;

    private static final float SIZE_MARGIN = 4.0e-6f;

    float lowX;
    float lowY;
    float lowZ;
    float highX;
    float highY;
    float highZ;

    /** Box of the centers. */
    float firstX;

    float firstY;
    float firstZ;
    float lastX;
    float lastY;
    float lastZ;

    /** Computes the boxes of a range of spheres in the hierarchy. */
    void hold(float[] hierarchy, int from, int to) {
        float minX = NOWHERE;
        float minY = NOWHERE;
        float minZ = NOWHERE;
        float maxX = -NOWHERE;
        float maxY = -NOWHERE;
        float maxZ = -NOWHERE;
        float x0 = NOWHERE;
        float y0 = NOWHERE;
        float z0 = NOWHERE;
        float x1 = -NOWHERE;
        float y1 = -NOWHERE;
        float z1 = -NOWHERE;
        for (int at = from; at < to; at += Layout.SPHERE_STRIDE) {
            float x = hierarchy[at];
            float y = hierarchy[at + 1];
            float z = hierarchy[at + 2];
            float radius = hierarchy[at + Layout.SPHERE_RADIUS];
            x0 = Math.min(x0, x);
            y0 = Math.min(y0, y);
            z0 = Math.min(z0, z);
            x1 = Math.max(x1, x);
            y1 = Math.max(y1, y);
            z1 = Math.max(z1, z);
            minX = Math.min(minX, x - radius);
            minY = Math.min(minY, y - radius);
            minZ = Math.min(minZ, z - radius);
            maxX = Math.max(maxX, x + radius);
            maxY = Math.max(maxY, y + radius);
            maxZ = Math.max(maxZ, z + radius);
        }
        lowX = minX;
        lowY = minY;
        lowZ = minZ;
        highX = maxX;
        highY = maxY;
        highZ = maxZ;
        firstX = x0;
        firstY = y0;
        firstZ = z0;
        lastX = x1;
        lastY = y1;
        lastZ = z1;
    }

    /** Resets to empty boxes. */
    void clear() {
        lowX = NOWHERE;
        lowY = NOWHERE;
        lowZ = NOWHERE;
        highX = -NOWHERE;
        highY = -NOWHERE;
        highZ = -NOWHERE;
        firstX = NOWHERE;
        firstY = NOWHERE;
        firstZ = NOWHERE;
        lastX = -NOWHERE;
        lastY = -NOWHERE;
        lastZ = -NOWHERE;
    }

    /** Adds a box given by minimum x, y, z and maximum x, y, z; its midpoint counts as the center. */
    void add(float[] sides, int at) {
        lowX = Math.min(lowX, sides[at]);
        lowY = Math.min(lowY, sides[at + 1]);
        lowZ = Math.min(lowZ, sides[at + 2]);
        highX = Math.max(highX, sides[at + 3]);
        highY = Math.max(highY, sides[at + 4]);
        highZ = Math.max(highZ, sides[at + 5]);
        float x = middle(sides, at);
        float y = middle(sides, at + 1);
        float z = middle(sides, at + 2);
        firstX = Math.min(firstX, x);
        firstY = Math.min(firstY, y);
        firstZ = Math.min(firstZ, z);
        lastX = Math.max(lastX, x);
        lastY = Math.max(lastY, y);
        lastZ = Math.max(lastZ, z);
    }

    /** Midpoint of a low side and its high side. */
    static float middle(float[] sides, int at) {
        return 0.5f * (sides[at] + sides[at + 3]);
    }

    /** Axis along which the centers are spread farthest: 0 for x, 1 for y, 2 for z. */
    int longestAxis() {
        float x = lastX - firstX;
        float y = lastY - firstY;
        float z = lastZ - firstZ;
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    /** Smallest coordinate of a center along an axis. */
    float first(int axis) {
        return axis == 0 ? firstX : axis == 1 ? firstY : firstZ;
    }

    /** Largest coordinate of a center along an axis. */
    float last(int axis) {
        return axis == 0 ? lastX : axis == 1 ? lastY : lastZ;
    }

    /** Whether the range is wide enough to be divided into bins or cells. */
    static boolean areApart(float low, float high) {
        return high - low > 1e-6f * Math.max(Math.abs(low), Math.abs(high)) && high - low > 1e-30f;
    }

    /** Writes the box of the spheres to a node. */
    void write(float[] hierarchy, int node) {
        writeSides(hierarchy, node, lowX, highX);
        writeSides(hierarchy, node + 1, lowY, highY);
        writeSides(hierarchy, node + 2, lowZ, highZ);
        float all = hierarchy[node + Layout.NODE_HALF]
                + hierarchy[node + Layout.NODE_HALF + 1]
                + hierarchy[node + Layout.NODE_HALF + 2];
        hierarchy[node + Layout.NODE_HALF] += SIZE_MARGIN * all;
        hierarchy[node + Layout.NODE_HALF + 1] += SIZE_MARGIN * all;
        hierarchy[node + Layout.NODE_HALF + 2] += SIZE_MARGIN * all;
    }

    private static void writeSides(float[] hierarchy, int at, float low, float high) {
        float center = 0.5f * (low + high);
        float farther = Math.max(Math.abs(low), Math.abs(high));
        hierarchy[at + Layout.NODE_CENTER] = center;
        hierarchy[at + Layout.NODE_HALF] = Math.max(high - center, center - low) + PLACE_MARGIN * farther;
    }
}
