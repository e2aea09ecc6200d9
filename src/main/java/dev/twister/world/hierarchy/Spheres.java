package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;

/**
 * The spheres of a hierarchy, laid out as in {@link Layout}.
 *
 * @param floats has the hierarchy
 * @param first place of the first sphere
 * @param mostInLeaf largest number of spheres in a leaf
 */
@SuppressWarnings("ArrayRecordComponent") // reordered in place
record Spheres(float[] floats, int first, int mostInLeaf) implements Subtree.Items {
    /** With more ancestors, a node is split at the median, which bounds the depth of all trees. */
    static final int MOST_UNEVEN_ANCESTORS = 28;

    @Override
    public int hold(int start, int end, Bounds bounds) {
        bounds.holdSpheres(floats, linkToItem(start), linkToItem(end));
        return end;
    }

    @Override
    public int split(int start, int end, int ancestors, Bounds bounds, Bins bins) {
        int axis = bounds.longestAxis();
        int middle = (start + end) / 2;
        if (ancestors < MOST_UNEVEN_ANCESTORS && bins.start(end - start, bounds.first(axis), bounds.last(axis))) {
            bins.fill(floats, linkToItem(start), linkToItem(end), axis);
            int border = bins.findBorder();
            middle = start + bins.before;
            part(linkToItem(start), linkToItem(end), axis, border, bins);
        }
        return middle;
    }

    /** Moves the spheres before a bin to the front. */
    private void part(int from, int to, int axis, int border, Bins bins) {
        int head = from;
        int tail = to - Layout.SPHERE_STRIDE;
        while (head < tail) {
            if (bins.bin(floats[head + axis]) < border) {
                head += Layout.SPHERE_STRIDE;
            } else if (bins.bin(floats[tail + axis]) >= border) {
                tail -= Layout.SPHERE_STRIDE;
            } else {
                for (int i = 0; i < Layout.SPHERE_STRIDE; i++) {
                    float swapped = floats[head + i];
                    floats[head + i] = floats[tail + i];
                    floats[tail + i] = swapped;
                }
                head += Layout.SPHERE_STRIDE;
                tail -= Layout.SPHERE_STRIDE;
            }
        }
    }

    @Override
    public int linkToItem(int item) {
        return first + Layout.SPHERE_STRIDE * item;
    }
}
