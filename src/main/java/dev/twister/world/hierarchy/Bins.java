package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import java.util.Arrays;

/** Equal bins along one axis over the centers of items, with the number of spheres or boxes and the box of each bin. */
final class Bins {
    private static final int MOST = 16;

    /** With fewer items, half as many bins are used. */
    private static final int FEW_ITEMS = 32;

    private static final float NOWHERE = Float.MAX_VALUE;

    /** Keeps the last center within the last bin. */
    private static final float INSIDE = 0.99999f;

    private final int[] counts = new int[MOST];

    /** Minimum x, y, z of each bin. */
    private final float[] low = new float[3 * MOST];

    /** Maximum x, y, z of each bin. */
    private final float[] high = new float[3 * MOST];

    /** Cost of the items in the bins up to each. */
    private final float[] costsBelow = new float[MOST];

    /** Cost of the items in the bins from each on. */
    private final float[] costsAbove = new float[MOST];

    private int count;
    private float start;
    private float scale;

    /** Number of items before the border; a result of {@link #findBorder}. */
    int before;

    /**
     * Clears the bins.
     *
     * @param items number of items to sort
     * @param first smallest coordinate of a center
     * @param last largest coordinate of a center
     * @return false if the centers are too close to each other
     */
    boolean start(int items, float first, float last) {
        if (!Bounds.areApart(first, last)) {
            return false;
        }
        count = items < FEW_ITEMS ? MOST / 2 : MOST;
        start = first;
        scale = count * INSIDE / (last - first);
        Arrays.fill(counts, 0, count, 0);
        Arrays.fill(low, 0, 3 * count, NOWHERE);
        Arrays.fill(high, 0, 3 * count, -NOWHERE);
        return true;
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
            widen(3 * bin, hierarchy[at] - radius, hierarchy[at] + radius);
            widen(3 * bin + 1, hierarchy[at + 1] - radius, hierarchy[at + 1] + radius);
            widen(3 * bin + 2, hierarchy[at + 2] - radius, hierarchy[at + 2] + radius);
        }
    }

    /** Adds spheres to a bin by their number and bounding box: minimum x, y, z and maximum x, y, z. */
    void add(int bin, int spheres, float[] sides, int at) {
        counts[bin] += spheres;
        widen(3 * bin, sides[at], sides[at + 3]);
        widen(3 * bin + 1, sides[at + 1], sides[at + 4]);
        widen(3 * bin + 2, sides[at + 2], sides[at + 5]);
    }

    private void widen(int at, float least, float most) {
        low[at] = Math.min(low[at], least);
        high[at] = Math.max(high[at], most);
    }

    /** The bin of a coordinate. */
    int bin(float coordinate) {
        return (int) ((coordinate - start) * scale);
    }

    /** The bin at which a split costs least: the sum over both sides of surface area times number of items. */
    int findBorder() {
        sum(count - 1, -1, costsAbove);
        int all = sum(0, 1, costsBelow);
        float least = Float.POSITIVE_INFINITY;
        int best = 1;
        before = counts[0];
        int items = 0;
        for (int bin = 0; bin < count - 1; bin++) {
            items += counts[bin];
            float cost = costsBelow[bin] + costsAbove[bin + 1];
            if (cost < least && items < all) {
                least = cost;
                best = bin + 1;
                before = items;
            }
        }
        return best;
    }

    /** Writes the costs of the items in the bins from one end to each; returns the number of all. */
    private int sum(int first, int step, float[] costs) {
        float lowX = NOWHERE;
        float lowY = NOWHERE;
        float lowZ = NOWHERE;
        float highX = -NOWHERE;
        float highY = -NOWHERE;
        float highZ = -NOWHERE;
        int items = 0;
        for (int i = 0; i < count; i++) {
            int bin = first + step * i;
            int box = 3 * bin;
            lowX = Math.min(lowX, low[box]);
            lowY = Math.min(lowY, low[box + 1]);
            lowZ = Math.min(lowZ, low[box + 2]);
            highX = Math.max(highX, high[box]);
            highY = Math.max(highY, high[box + 1]);
            highZ = Math.max(highZ, high[box + 2]);
            items += counts[bin];
            costs[bin] = cost(highX - lowX, highY - lowY, highZ - lowZ, items);
        }
        return items;
    }

    /** Relative cost; 0 for an empty side, whose box is inverted. */
    private static float cost(float x, float y, float z, int items) {
        return items == 0 ? 0 : items * (x * y + y * z + z * x);
    }
}
