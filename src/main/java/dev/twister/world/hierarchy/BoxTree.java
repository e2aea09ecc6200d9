package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.IntFunction;

/** Builds a bounding volume hierarchy over boxes. Its links are numbers of nodes and boxes. */
public final class BoxTree {
    /** With more ancestors, boxes are split at the median; then 2^24 boxes stay within the kernel's stack. */
    private static final int MOST_UNEVEN_ANCESTORS = Layout.MOST_ANCESTORS - 24;

    private BoxTree() {}

    /**
     * Builds the nodes, with the root first.
     *
     * @param sides {@code float[6 * boxes]}, at least one box: minimum x, y, z and maximum x, y, z; reordered like the
     *     leaves
     * @param order {@code int[boxes]}: receives the boxes' numbers in the order of the leaves
     * @param mostInLeaf largest number of boxes per leaf, at least 1
     * @param content of a box by its number; of many boxes in one place with equal contents only the lowest is in a
     *     leaf
     */
    public static float[] nodes(float[] sides, int[] order, int mostInLeaf, IntFunction<?> content) {
        Arrays.setAll(order, box -> box);
        float[] spread = new float[Layout.NODE_STRIDE * (2 * order.length - 1)];
        Items items = new Items(new Boxes(sides, order), mostInLeaf, content);
        new Subtree(items, spread, 0, Layout.NODE_STRIDE, 0, order.length, 0).invoke();
        float[] nodes = new float[spread.length];
        System.arraycopy(spread, 0, nodes, 0, Layout.NODE_STRIDE);
        int count = gather(spread, 0, nodes, 0, 1);
        return Arrays.copyOf(nodes, Layout.NODE_STRIDE * count);
    }

    /** Copies the descendants of a copied node without gaps; returns the new number of nodes. */
    private static int gather(float[] spread, int node, float[] nodes, int copy, int count) {
        if (spread[Layout.NODE_STRIDE * node + Layout.NODE_SPHERES] >= 0) {
            return count;
        }
        int child = (int) spread[Layout.NODE_STRIDE * node + Layout.NODE_LINK];
        System.arraycopy(spread, Layout.NODE_STRIDE * child, nodes, Layout.NODE_STRIDE * count, 2 * Layout.NODE_STRIDE);
        nodes[Layout.NODE_STRIDE * copy + Layout.NODE_LINK] = count;
        int first = gather(spread, child, nodes, count, count + 2);
        return gather(spread, child + 1, nodes, count + 1, first);
    }

    private record Items(Boxes boxes, int mostInLeaf, IntFunction<?> content) implements Subtree.Items {
        @Override
        public int hold(int start, int end, Bounds bounds) {
            bounds.holdBoxes(boxes.sides(), start, end);
            return end - start > mostInLeaf && !bounds.areApart() ? withoutCopies(start, end) : end;
        }

        /** Moves the lowest box of each content to the front; returns where they end. */
        private int withoutCopies(int start, int end) {
            int[] order = boxes.numbers();
            Map<Object, Integer> lowest = new HashMap<>();
            for (int box = start; box < end; box++) {
                lowest.merge(content.apply(order[box]), order[box], Math::min);
            }
            Set<Integer> first = new HashSet<>(lowest.values());
            int kept = start;
            for (int box = start; box < end; box++) {
                if (first.contains(order[box])) {
                    boxes.swap(box, kept);
                    kept++;
                }
            }
            return kept;
        }

        /** Partitions the boxes by their centers, or by their sizes if they have one center. */
        @Override
        public int split(int start, int end, int ancestors, Bounds bounds, Bins bins) {
            int axis = bounds.longestAxis();
            float low = bounds.first(axis);
            float high = bounds.last(axis);
            if (!bounds.areApart()) {
                axis = Boxes.SIZE;
                low = Float.MAX_VALUE;
                high = 0;
                for (int box = start; box < end; box++) {
                    low = Math.min(low, boxes.coordinate(box, axis));
                    high = Math.max(high, boxes.coordinate(box, axis));
                }
            }
            if (ancestors >= MOST_UNEVEN_ANCESTORS || !bins.start(end - start, low, high)) {
                return (start + end) / 2;
            }
            for (int box = start; box < end; box++) {
                boxes.add(box, 1, axis, bins);
            }
            return boxes.part(start, end, axis, bins);
        }

        @Override
        public int linkToNode(int place) {
            return place / Layout.NODE_STRIDE;
        }

        @Override
        public int linkToItem(int item) {
            return item;
        }
    }
}
