package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import java.util.Arrays;

/**
 * Equal bins along one axis over the centers of spheres, with the number of spheres and the bounding box of each bin.
 */
final class Bins {
    private static final int MOST = 16;

    /** With fewer items, half as many bins are used. */
    private static final int FEW_ITEMS = 32;

    private static final float NOWHERE = Float.MAX_VALUE;

    /** Keeps the last center within the last bin. */
    private static final float INSIDE = 0.99999f;

    private final int[] counts = new int[MOST];

    /** Minimum x, y, z and maximum x, y, z of each bin. */
    private final float[] boxes = new float[6 * MOST];

    /** Cost of the spheres in the bins from each index on. */
    private final float[] costsAbove = new float[MOST];

    private int count;
    private float start;
    private float scale;

    /** Number of spheres before the border; a result of {@link #findBorder}. */
    int before;

    /**
     * Clears the bins.
     *
     * @param items number of items to sort
     * @param low smallest coordinate of a center
     * @param high largest coordinate of a center, greater than {@code low}
     */
    void start(int items, float low, float high) {
        count = items < FEW_ITEMS ? MOST / 2 : MOST;
        start = low;
        scale = count * INSIDE / (high - low);
        Arrays.fill(counts, 0, count, 0);
        for (int bin = 0; bin < count; bin++) {
            int box = 6 * bin;
            boxes[box] = NOWHERE;
            boxes[box + 1] = NOWHERE;
            boxes[box + 2] = NOWHERE;
            boxes[box + 3] = -NOWHERE;
            boxes[box + 4] = -NOWHERE;
            boxes[box + 5] = -NOWHERE;
        }
    }

    /**
     * Sorts spheres into the bins.
     *
     * @param along axis: 0 for x, 1 for y, 2 for z
     */
    void fill(float[] hierarchy, int from, int to, int along) {
        for (int at = from; at < to; at += Layout.SPHERE_STRIDE) {
            int bin = bin(hierarchy[at + along]);
            counts[bin]++;
            float radius = hierarchy[at + Layout.SPHERE_RADIUS];
            widen(6 * bin, hierarchy[at] - radius, hierarchy[at] + radius);
            widen(6 * bin + 1, hierarchy[at + 1] - radius, hierarchy[at + 1] + radius);
            widen(6 * bin + 2, hierarchy[at + 2] - radius, hierarchy[at + 2] + radius);
        }
    }

    /** Adds spheres to a bin by their number and bounding box: minimum x, y, z and maximum x, y, z. */
    void add(int bin, int spheres, float[] sides, int at) {
        counts[bin] += spheres;
        widen(6 * bin, sides[at], sides[at + 3]);
        widen(6 * bin + 1, sides[at + 1], sides[at + 4]);
        widen(6 * bin + 2, sides[at + 2], sides[at + 5]);
    }

    private void widen(int at, float low, float high) {
        boxes[at] = Math.min(boxes[at], low);
        boxes[at + 3] = Math.max(boxes[at + 3], high);
    }

    /** The bin of a coordinate. */
    int bin(float coordinate) {
        return (int) ((coordinate - start) * scale);
    }

    /** The bin at which a split costs least: the sum over both sides of surface area times number of spheres. */
    int findBorder() {
        float lowX = NOWHERE;
        float lowY = NOWHERE;
        float lowZ = NOWHERE;
        float highX = -NOWHERE;
        float highY = -NOWHERE;
        float highZ = -NOWHERE;
        int spheres = 0;
        for (int bin = count - 1; bin > 0; bin--) {
            int box = 6 * bin;
            lowX = Math.min(lowX, boxes[box]);
            lowY = Math.min(lowY, boxes[box + 1]);
            lowZ = Math.min(lowZ, boxes[box + 2]);
            highX = Math.max(highX, boxes[box + 3]);
            highY = Math.max(highY, boxes[box + 4]);
            highZ = Math.max(highZ, boxes[box + 5]);
            spheres += counts[bin];
            costsAbove[bin] = cost(highX - lowX, highY - lowY, highZ - lowZ, spheres);
        }
        int all = spheres + counts[0];
        lowX = NOWHERE;
        lowY = NOWHERE;
        lowZ = NOWHERE;
        highX = -NOWHERE;
        highY = -NOWHERE;
        highZ = -NOWHERE;
        spheres = 0;
        float least = Float.POSITIVE_INFINITY;
        int best = 1;
        for (int bin = 0; bin < count - 1; bin++) {
            int box = 6 * bin;
            lowX = Math.min(lowX, boxes[box]);
            lowY = Math.min(lowY, boxes[box + 1]);
            lowZ = Math.min(lowZ, boxes[box + 2]);
            highX = Math.max(highX, boxes[box + 3]);
            highY = Math.max(highY, boxes[box + 4]);
            highZ = Math.max(highZ, boxes[box + 5]);
            spheres += counts[bin];
            float cost = cost(highX - lowX, highY - lowY, highZ - lowZ, spheres) + costsAbove[bin + 1];
            if (cost < least && spheres < all) {
                least = cost;
                best = bin + 1;
                before = spheres;
            }
        }
        return best;
    }

    /** Relative cost; 0 for an empty side, whose box is inverted. */
    private static float cost(float x, float y, float z, int spheres) {
        return spheres == 0 ? 0 : spheres * (x * y + y * z + z * x);
    }

    /** Moves the spheres before the border to the front. */
    void part(float[] hierarchy, int from, int to, int axis, int border) {
        int head = from;
        int tail = to - Layout.SPHERE_STRIDE;
        while (head < tail) {
            if (bin(hierarchy[head + axis]) < border) {
                head += Layout.SPHERE_STRIDE;
            } else if (bin(hierarchy[tail + axis]) >= border) {
                tail -= Layout.SPHERE_STRIDE;
            } else {
                for (int i = 0; i < Layout.SPHERE_STRIDE; i++) {
                    float swapped = hierarchy[head + i];
                    hierarchy[head + i] = hierarchy[tail + i];
                    hierarchy[tail + i] = swapped;
                }
                head += Layout.SPHERE_STRIDE;
                tail -= Layout.SPHERE_STRIDE;
            }
        }
    }
}
