package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import java.util.concurrent.RecursiveAction;
import java.util.stream.IntStream;

/**
 * Builds the nodes over some cells. It partitions cells while there are many spheres, then single spheres. For large
 * parts another thread builds one of the halves.
 */
final class CellTree extends RecursiveAction {
    private static final long serialVersionUID = 1;

    /** Cells with fewer spheres in total are split by single spheres. */
    private static final int FEWEST_SPHERES = 48;

    /**
     * With more ancestors, cells are split at the median; then {@link SphereCells#MOST} cells end at the depth where
     * {@link Subtree} does the same.
     */
    private static final int MOST_UNEVEN_ANCESTORS =
            Subtree.MOST_UNEVEN_ANCESTORS - Integer.numberOfTrailingZeros(SphereCells.MOST);

    @SuppressWarnings("serial") // never written
    private final Bins bins = new Bins();

    @SuppressWarnings("serial") // never written
    private final Bounds bounds = new Bounds();

    @SuppressWarnings("serial") // never written
    private final SphereCells cells;

    /** The numbers of the cells, in the order of the tree. */
    private final int[] order;

    private final float[] hierarchy;
    private final int node;
    private final int room;
    private final int firstCell;
    private final int lastCell;
    private final int from;
    private final int ancestors;
    private final int mostInLeaf;

    @SuppressWarnings("serial") // never written
    private final Subtree lower;

    /**
     * The whole tree.
     *
     * @param start place of the first sphere
     * @param root place of the root, after the spheres
     * @param room place of the reserved room for the other nodes
     */
    CellTree(SphereCells cells, float[] hierarchy, int start, int root, int room, int mostInLeaf) {
        this(
                cells,
                IntStream.range(0, cells.count)
                        .filter(cell -> cells.spheresIn(cell) > 0)
                        .toArray(),
                hierarchy,
                root,
                room,
                0,
                -1,
                start,
                0,
                mostInLeaf);
    }

    private CellTree(
            SphereCells cells,
            int[] order,
            float[] hierarchy,
            int node,
            int room,
            int firstCell,
            int lastCell,
            int from,
            int ancestors,
            int mostInLeaf) {
        this.cells = cells;
        this.order = order;
        this.hierarchy = hierarchy;
        this.node = node;
        this.room = room;
        this.firstCell = firstCell;
        this.lastCell = lastCell < 0 ? order.length : lastCell;
        this.from = from;
        this.ancestors = ancestors;
        this.mostInLeaf = mostInLeaf;
        lower = new Subtree(hierarchy, node, room, from, from, ancestors, mostInLeaf);
    }

    @Override
    protected void compute() {
        grow(node, room, firstCell, lastCell, from, ancestors);
    }

    /** Builds the nodes over some cells, whose spheres are written from {@code place} on. */
    private void grow(int at, int free, int start, int end, int place, int above) {
        int spheres = 0;
        for (int i = start; i < end; i++) {
            spheres += cells.spheresIn(order[i]);
        }
        if (end - start == 1 || spheres <= Math.max(FEWEST_SPHERES, mostInLeaf)) {
            int behind = place;
            for (int i = start; i < end; i++) {
                int length = Layout.SPHERE_STRIDE * cells.spheresIn(order[i]);
                System.arraycopy(
                        cells.spheres, Layout.SPHERE_STRIDE * cells.firsts[order[i]], hierarchy, behind, length);
                behind += length;
            }
            lower.grow(at, free, place, behind, above);
        } else {
            split(at, free, start, end, place, above);
        }
    }

    private void split(int at, int free, int start, int end, int place, int above) {
        int middle = part(start, end, above);
        bounds.write(hierarchy, at);
        int before = 0;
        for (int i = start; i < middle; i++) {
            before += cells.spheresIn(order[i]);
        }
        int second = free + Layout.NODE_STRIDE;
        int firstRoom = second + Layout.NODE_STRIDE;
        int secondRoom = firstRoom + 2 * (before - 1) * Layout.NODE_STRIDE;
        int secondPlace = place + Layout.SPHERE_STRIDE * before;
        hierarchy[at + Layout.NODE_LINK] = free;
        hierarchy[at + Layout.NODE_SPHERES] = -1;
        if (before >= Subtree.FEWEST_FOR_A_THREAD) {
            CellTree other = new CellTree(
                    cells, order, hierarchy, second, secondRoom, middle, end, secondPlace, above + 1, mostInLeaf);
            other.fork();
            grow(free, firstRoom, start, middle, place, above + 1);
            other.join();
        } else {
            grow(free, firstRoom, start, middle, place, above + 1);
            grow(second, secondRoom, middle, end, secondPlace, above + 1);
        }
    }

    /** Partitions the cells and computes the box around all of them; returns the start of the second part. */
    private int part(int start, int end, int above) {
        bounds.clear();
        for (int i = start; i < end; i++) {
            bounds.add(cells.boxes, 6 * order[i]);
        }
        int axis = bounds.longestAxis();
        float low = bounds.first(axis);
        float high = bounds.last(axis);
        int head = (start + end) / 2;
        if (Bounds.areApart(low, high) && above < MOST_UNEVEN_ANCESTORS) {
            bins.start(end - start, low, high);
            for (int i = start; i < end; i++) {
                int cell = order[i];
                bins.add(binOf(cell, axis), cells.spheresIn(cell), cells.boxes, 6 * cell);
            }
            int border = bins.findBorder();
            head = start;
            int tail = end - 1;
            while (head <= tail) {
                int cell = order[head];
                if (binOf(cell, axis) < border) {
                    head++;
                } else {
                    order[head] = order[tail];
                    order[tail] = cell;
                    tail--;
                }
            }
        }
        return head;
    }

    private int binOf(int cell, int axis) {
        return bins.bin(Bounds.middle(cells.boxes, 6 * cell + axis));
    }
}
