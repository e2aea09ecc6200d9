package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import java.util.concurrent.RecursiveAction;

/** Builds the nodes over some spheres; for large parts another thread builds one of the halves. */
final class Subtree extends RecursiveAction {
    private static final long serialVersionUID = 1;

    /** Halves with fewer spheres are not worth another thread. */
    static final int FEWEST_FOR_A_THREAD = 2048;

    /** With more ancestors, a node is split at the median, which bounds the depth of all trees. */
    static final int MOST_UNEVEN_ANCESTORS = 28;

    @SuppressWarnings("serial") // never written
    private final Bins bins = new Bins();

    @SuppressWarnings("serial") // never written
    private final Bounds bounds = new Bounds();

    private final float[] hierarchy;
    private final int node;
    private final int room;
    private final int from;
    private final int to;
    private final int ancestors;
    private final int mostInLeaf;

    /**
     * The nodes over the spheres at {@code [from, to)} of the hierarchy.
     *
     * @param node place of the topmost node
     * @param room place of the reserved room for the others
     * @param ancestors number of nodes above
     */
    Subtree(float[] hierarchy, int node, int room, int from, int to, int ancestors, int mostInLeaf) {
        this.hierarchy = hierarchy;
        this.node = node;
        this.room = room;
        this.from = from;
        this.to = to;
        this.ancestors = ancestors;
        this.mostInLeaf = mostInLeaf;
    }

    @Override
    protected void compute() {
        grow(node, room, from, to, ancestors);
    }

    /** Builds the nodes over the spheres at {@code [start, end)}; the parameters are like the constructor's. */
    void grow(int at, int free, int start, int end, int above) {
        bounds.hold(hierarchy, start, end);
        int spheres = (end - start) / Layout.SPHERE_STRIDE;
        writeBox(at, spheres);
        if (spheres <= mostInLeaf) {
            hierarchy[at + Layout.NODE_LINK] = start;
            hierarchy[at + Layout.NODE_SPHERES] = spheres;
        } else {
            int before = split(start, end, above);
            int middle = start + Layout.SPHERE_STRIDE * before;
            int second = free + Layout.NODE_STRIDE;
            int firstRoom = second + Layout.NODE_STRIDE;
            int secondRoom = firstRoom + 2 * (before - 1) * Layout.NODE_STRIDE;
            hierarchy[at + Layout.NODE_LINK] = free;
            hierarchy[at + Layout.NODE_SPHERES] = -1;
            if (Math.min(before, spheres - before) >= FEWEST_FOR_A_THREAD) {
                Subtree other = new Subtree(hierarchy, second, secondRoom, middle, end, above + 1, mostInLeaf);
                other.fork();
                grow(free, firstRoom, start, middle, above + 1);
                other.join();
            } else {
                grow(free, firstRoom, start, middle, above + 1);
                grow(second, secondRoom, middle, end, above + 1);
            }
        }
    }

    /** Partitions the spheres; returns the number in the first part. */
    private int split(int start, int end, int above) {
        int axis = bounds.longestAxis();
        float low = bounds.first(axis);
        float high = bounds.last(axis);
        int before = (end - start) / Layout.SPHERE_STRIDE / 2;
        if (Bounds.areApart(low, high) && above < MOST_UNEVEN_ANCESTORS) {
            bins.start((end - start) / Layout.SPHERE_STRIDE, low, high);
            bins.fill(hierarchy, start, end, axis);
            int border = bins.findBorder();
            before = bins.before;
            bins.part(hierarchy, start, end, axis, border);
        }
        return before;
    }

    private void writeBox(int at, int spheres) {
        if (spheres > 0) {
            bounds.write(hierarchy, at);
        }
    }
}
