package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.RecursiveAction;
import java.util.function.IntFunction;

/**
 * Builds a bounding volume hierarchy over boxes, as {@link SphereHierarchy} does over spheres: by the surface area
 * heuristic, evaluated at the borders of equal bins, on all cores. Links are numbers of nodes and boxes.
 */
public final class BoxTree extends RecursiveAction {
    private static final long serialVersionUID = 1;

    private static final int FEWEST_FOR_A_THREAD = 8192;

    /** Instead of an axis. */
    private static final int SIZE = 3;

    /** With more ancestors, boxes are split at the median; then 2^24 boxes stay within the kernel's stack. */
    private static final int MOST_UNEVEN_ANCESTORS = Layout.MOST_ANCESTORS - 24;

    @SuppressWarnings("serial") // never written
    private final Bins bins = new Bins();

    @SuppressWarnings("serial") // never written
    private final Bounds bounds = new Bounds();

    @SuppressWarnings("serial") // never written
    private final Boxes input;

    private final float[] boxes;
    private final int[] order;
    private final float[] nodes;
    private final int node;
    private final int room;
    private final int from;
    private final int to;
    private final int ancestors;

    /**
     * What is to be found.
     *
     * @param sides {@code float[6 * boxes]}, at least one box: minimum x, y, z and maximum x, y, z; reordered like the
     *     leaves
     * @param order {@code int[boxes]}: receives the boxes' numbers in the order of the leaves
     * @param mostInLeaf largest number of boxes per leaf, at least 1
     * @param content of a box by its number; of many boxes in one place with equal contents only the lowest is in a
     *     leaf
     */
    @SuppressWarnings("ArrayRecordComponent") // reordered in place
    public record Boxes(float[] sides, int[] order, int mostInLeaf, IntFunction<?> content) {}

    private BoxTree(Boxes input, float[] nodes, int node, int room, int from, int to, int ancestors) {
        this.input = input;
        this.boxes = input.sides();
        this.order = input.order();
        this.nodes = nodes;
        this.node = node;
        this.room = room;
        this.from = from;
        this.to = to;
        this.ancestors = ancestors;
    }

    /** Builds the nodes, with the root first. */
    public static float[] nodes(Boxes input) {
        int[] order = input.order();
        Arrays.setAll(order, box -> box);
        float[] spread = new float[Layout.NODE_STRIDE * (2 * order.length - 1)];
        new BoxTree(input, spread, 0, 1, 0, order.length, 0).invoke();
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

    @Override
    protected void compute() {
        grow(node, room, from, to, ancestors);
    }

    /**
     * Builds the nodes over the boxes at {@code [start, end)}: the topmost one at {@code at}, the others from
     * {@code free} on.
     */
    private void grow(int at, int free, int start, int last, int above) {
        bounds.clear();
        for (int box = start; box < last; box++) {
            bounds.add(boxes, 6 * box);
        }
        int place = Layout.NODE_STRIDE * at;
        bounds.write(nodes, place);
        int end = last - start > input.mostInLeaf() && !centersAreApart() ? withoutCopies(start, last) : last;
        if (end - start <= input.mostInLeaf()) {
            nodes[place + Layout.NODE_LINK] = start;
            nodes[place + Layout.NODE_SPHERES] = end - start;
        } else {
            int middle = split(start, end, above);
            nodes[place + Layout.NODE_LINK] = free;
            nodes[place + Layout.NODE_SPHERES] = -1;
            int firstRoom = free + 2;
            int secondRoom = firstRoom + 2 * (middle - start - 1);
            if (Math.min(middle - start, end - middle) >= FEWEST_FOR_A_THREAD) {
                BoxTree other = new BoxTree(input, nodes, free + 1, secondRoom, middle, end, above + 1);
                other.fork();
                grow(free, firstRoom, start, middle, above + 1);
                other.join();
            } else {
                grow(free, firstRoom, start, middle, above + 1);
                grow(free + 1, secondRoom, middle, end, above + 1);
            }
        }
    }

    private boolean centersAreApart() {
        int axis = bounds.longestAxis();
        return Bounds.areApart(bounds.first(axis), bounds.last(axis));
    }

    /** Moves the lowest box of each content to the front; returns where they end. */
    private int withoutCopies(int start, int end) {
        Map<Object, Integer> lowest = new HashMap<>();
        for (int box = start; box < end; box++) {
            lowest.merge(input.content().apply(order[box]), order[box], Math::min);
        }
        Set<Integer> first = new HashSet<>(lowest.values());
        int kept = start;
        for (int box = start; box < end; box++) {
            if (first.contains(order[box])) {
                swap(box, kept);
                kept++;
            }
        }
        return kept;
    }

    /** Partitions the boxes by their centers, or by their sizes if they have one center; returns the second's start. */
    private int split(int start, int end, int above) {
        int axis = centersAreApart() ? bounds.longestAxis() : SIZE;
        float low = bounds.first(axis % SIZE);
        float high = bounds.last(axis % SIZE);
        if (axis == SIZE) {
            low = Float.MAX_VALUE;
            high = 0;
            for (int box = start; box < end; box++) {
                low = Math.min(low, coordinate(box, axis));
                high = Math.max(high, coordinate(box, axis));
            }
        }
        int middle = (start + end) / 2;
        if (Bounds.areApart(low, high) && above < MOST_UNEVEN_ANCESTORS) {
            bins.start(end - start, low, high);
            for (int box = start; box < end; box++) {
                bins.add(bins.bin(coordinate(box, axis)), 1, boxes, 6 * box);
            }
            int border = bins.findBorder();
            middle = start;
            int tail = end - 1;
            while (middle <= tail) {
                if (bins.bin(coordinate(middle, axis)) < border) {
                    middle++;
                } else {
                    swap(middle, tail);
                    tail--;
                }
            }
        }
        return middle;
    }

    private float coordinate(int box, int axis) {
        int at = 6 * box;
        return axis == SIZE
                ? boxes[at + 3] - boxes[at] + boxes[at + 4] - boxes[at + 1] + boxes[at + 5] - boxes[at + 2]
                : Bounds.middle(boxes, at + axis);
    }

    private void swap(int one, int other) {
        for (int i = 0; i < 6; i++) {
            float side = boxes[6 * one + i];
            boxes[6 * one + i] = boxes[6 * other + i];
            boxes[6 * other + i] = side;
        }
        int number = order[one];
        order[one] = order[other];
        order[other] = number;
    }
}
