package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import java.util.concurrent.RecursiveAction;

/**
 * Builds the nodes over some items, split by the surface area heuristic (Goldsmith and Salmon 1987), which is evaluated
 * at the borders of equal bins (Wald 2007); for large parts another thread builds one of the halves.
 *
 * <p>A node over n spheres or boxes reserves room for its 2 n - 2 descendants directly after its children or its elder
 * sibling's room. Its location therefore does not depend on the order in which threads finish; leaves of several leave
 * gaps of zeros.
 */
final class Subtree extends RecursiveAction {
    private static final long serialVersionUID = 1;

    /** Smaller halves are not worth another thread. */
    private static final int FEWEST_FOR_A_THREAD = 2048;

    @SuppressWarnings("serial") // never written
    private final Bins bins = new Bins();

    @SuppressWarnings("serial") // never written
    private final Bounds bounds = new Bounds();

    @SuppressWarnings("serial") // never written
    private final Items items;

    private final float[] nodes;
    private final int node;
    private final int room;
    private final int from;
    private final int to;
    private final int ancestors;

    /** What a hierarchy is built over: spheres, cells of spheres, or boxes, numbered in the order of its leaves. */
    interface Items {
        /** Largest number of spheres or boxes in a leaf. */
        int mostInLeaf();

        /** Number of spheres or boxes before an item at which a range starts or ends. */
        default int before(int item) {
            return item;
        }

        /** These items, or the spheres in them where they are so few that single ones are split from here on. */
        default Items opened(int start, int end) {
            return this;
        }

        /** Computes the bounds of a range; returns the end of those in it that have to be found. */
        int hold(int start, int end, Bounds bounds);

        /** Partitions a range with these bounds; returns the start of the second part, which isn't empty. */
        int split(int start, int end, int ancestors, Bounds bounds, Bins bins);

        /** A node's link to its children, the first of which is at this place. */
        default int linkToNode(int place) {
            return place;
        }

        /** A leaf's link to its first item. */
        int linkToItem(int item);
    }

    /**
     * The nodes over the items at {@code [from, to)}.
     *
     * @param node place of the topmost node
     * @param room place of the reserved room for the others
     * @param ancestors number of nodes above
     */
    Subtree(Items items, float[] nodes, int node, int room, int from, int to, int ancestors) {
        this.items = items;
        this.nodes = nodes;
        this.node = node;
        this.room = room;
        this.from = from;
        this.to = to;
        this.ancestors = ancestors;
    }

    @Override
    protected void compute() {
        grow(items, node, room, from, to, ancestors);
    }

    @SuppressWarnings("ReferenceEquality") // items that are not opened are themselves
    private void grow(Items whole, int at, int free, int start, int last, int above) {
        Items parts = whole.opened(start, last);
        int first = parts == whole ? start : whole.before(start);
        int end = parts.hold(first, parts == whole ? last : whole.before(last), bounds);
        int size = parts.before(end) - parts.before(first);
        if (size > 0) {
            bounds.write(nodes, at);
        }
        if (size <= parts.mostInLeaf()) {
            nodes[at + Layout.NODE_LINK] = parts.linkToItem(first);
            nodes[at + Layout.NODE_SPHERES] = size;
        } else {
            nodes[at + Layout.NODE_LINK] = parts.linkToNode(free);
            nodes[at + Layout.NODE_SPHERES] = -1;
            branch(parts, free, first, parts.split(first, end, above, bounds, bins), end, above + 1);
        }
    }

    private void branch(Items parts, int node, int start, int middle, int end, int above) {
        int before = parts.before(middle) - parts.before(start);
        int second = node + Layout.NODE_STRIDE;
        int firstRoom = second + Layout.NODE_STRIDE;
        int secondRoom = firstRoom + 2 * (before - 1) * Layout.NODE_STRIDE;
        if (Math.min(before, parts.before(end) - parts.before(middle)) >= FEWEST_FOR_A_THREAD) {
            Subtree other = new Subtree(parts, nodes, second, secondRoom, middle, end, above);
            other.fork();
            grow(parts, node, firstRoom, start, middle, above);
            other.join();
        } else {
            grow(parts, node, firstRoom, start, middle, above);
            grow(parts, second, secondRoom, middle, end, above);
        }
    }
}
