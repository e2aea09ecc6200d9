package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;
import java.util.stream.IntStream;

/**
 * Spheres sorted into the cells of a grid over their centers, with the bounding box of each cell. The upper levels of a
 * hierarchy partition cells instead of single spheres (as Ganestam and others do with small trees, 2015). The work is
 * parallel, and the order does not depend on the number of cores.
 */
final class SphereCells implements Subtree.Items {
    /** Few enough that partitioning them costs less than a pass over all spheres; enough for more than ten levels. */
    private static final int MOST = 4096;

    /** Cells with fewer spheres in total are split by single spheres. */
    private static final int FEWEST_SPHERES = 48;

    /**
     * With more ancestors, cells are split at the median; then {@link #MOST} cells end at the depth where single
     * spheres are split so too.
     */
    private static final int MOST_UNEVEN_ANCESTORS =
            Spheres.MOST_UNEVEN_ANCESTORS - Integer.numberOfTrailingZeros(MOST);

    private static final int SPHERES_A_CELL = 16;

    /** Number of ranges of spheres for parallel work. */
    private static final int RUNS = 8;

    /** Keeps the last center within the last cell. */
    private static final float INSIDE = 0.99999f;

    /** Number of cells that have spheres. */
    final int count;

    /** Receives the spheres as soon as their order is known. */
    private final Spheres ordered;

    /** The spheres, cell by cell, laid out as in {@link Layout}. */
    private final float[] spheres;

    /** Start of each cell's spheres, and the total, in spheres. */
    private final int[] firsts;

    /** The boxes around the spheres of cells that have some. */
    private final Boxes boxes;

    /** Number of spheres before each of these, where a range starts, and the total. */
    private final int[] before;

    private final float[] places;
    private final int bodies;
    private final int[] cells;
    private final float[] start = new float[3];
    private final float[] scale = new float[3];
    private final int[] along = new int[3];

    /** Sorts the spheres among these bodies, given {@link Bodies#floats}. */
    SphereCells(float[] places, int bodies, Spheres ordered) {
        this.ordered = ordered;
        this.places = places;
        this.bodies = bodies;
        int all = bodies - Layout.FIRST_SPHERE;
        cells = new int[all];
        spheres = new float[all * Layout.SPHERE_STRIDE];
        shape(all);
        int grid = along[0] * along[1] * along[2];
        firsts = new int[grid + 1];
        int[][] next = new int[RUNS][grid];
        IntStream.range(0, RUNS).parallel().forEach(run -> assign(run, next[run]));
        int sorted = 0;
        for (int cell = 0; cell < grid; cell++) {
            firsts[cell] = sorted;
            for (int[] nextOfRun : next) {
                int here = nextOfRun[cell];
                nextOfRun[cell] = sorted;
                sorted += here;
            }
        }
        firsts[grid] = sorted;
        int[] numbers =
                IntStream.range(0, grid).filter(cell -> spheresIn(cell) > 0).toArray();
        count = numbers.length;
        boxes = new Boxes(new float[6 * count], numbers);
        before = new int[count + 1];
        before[count] = sorted;
        IntStream.range(0, RUNS).parallel().forEach(run -> copy(run, next[run]));
        IntStream.range(0, RUNS).parallel().forEach(run -> findBoxes(count * run / RUNS, count * (run + 1) / RUNS));
    }

    private int firstBody(int run) {
        return Layout.FIRST_SPHERE + (int) ((long) (bodies - Layout.FIRST_SPHERE) * run / RUNS);
    }

    /** Chooses cells that are as close to cubes as integer counts allow. */
    private void shape(int all) {
        float[] low = new float[3];
        float[] extent = new float[3];
        IntStream.range(0, 3).parallel().forEach(axis -> {
            float least = places[Layout.PLACE_STRIDE * Layout.FIRST_SPHERE + axis];
            float most = least;
            for (int body = Layout.FIRST_SPHERE; body < bodies; body++) {
                float coordinate = places[Layout.PLACE_STRIDE * body + axis];
                least = coordinate < least ? coordinate : least;
                most = coordinate > most ? coordinate : most;
            }
            low[axis] = least;
            extent[axis] = Bounds.areApart(least, most) ? most - least : 0f;
        });
        double wanted = Math.min(MOST, all / SPHERES_A_CELL);
        double side = Math.max(extent[0], Math.max(extent[1], extent[2])) / wanted;
        while (cellsOfSide(extent, side) > wanted) {
            side *= 1.1;
        }
        for (int axis = 0; axis < 3; axis++) {
            along[axis] = cellsAlong(extent[axis], side);
            start[axis] = low[axis];
            scale[axis] = extent[axis] > 0f ? along[axis] * INSIDE / extent[axis] : 0;
        }
    }

    private static double cellsOfSide(float[] extent, double side) {
        return (double) cellsAlong(extent[0], side) * cellsAlong(extent[1], side) * cellsAlong(extent[2], side);
    }

    private static int cellsAlong(float extent, double side) {
        return side > 0 ? Math.max(1, (int) (extent / side)) : 1;
    }

    private void assign(int run, int[] counts) {
        int end = firstBody(run + 1);
        for (int body = firstBody(run); body < end; body++) {
            int place = Layout.PLACE_STRIDE * body;
            int x = (int) ((places[place] - start[0]) * scale[0]);
            int y = (int) ((places[place + 1] - start[1]) * scale[1]);
            int z = (int) ((places[place + 2] - start[2]) * scale[2]);
            int cell = x + along[0] * (y + along[1] * z);
            cells[body - Layout.FIRST_SPHERE] = cell;
            counts[cell]++;
        }
    }

    private void copy(int run, int[] next) {
        int end = firstBody(run + 1);
        for (int body = firstBody(run); body < end; body++) {
            int cell = cells[body - Layout.FIRST_SPHERE];
            int at = Layout.SPHERE_STRIDE * next[cell];
            next[cell]++;
            SphereHierarchy.writeSphere(spheres, at, places, body);
        }
    }

    private void findBoxes(int from, int to) {
        Bounds bounds = new Bounds();
        for (int item = from; item < to; item++) {
            int cell = boxes.numbers()[item];
            bounds.holdSpheres(spheres, Layout.SPHERE_STRIDE * firsts[cell], Layout.SPHERE_STRIDE * firsts[cell + 1]);
            bounds.writeSides(boxes.sides(), 6 * item);
        }
    }

    private int spheresIn(int cell) {
        return firsts[cell + 1] - firsts[cell];
    }

    @Override
    public int mostInLeaf() {
        return ordered.mostInLeaf();
    }

    @Override
    public int before(int item) {
        return before[item];
    }

    @Override
    public Subtree.Items opened(int start, int end) {
        if (end - start > 1 && before[end] - before[start] > Math.max(FEWEST_SPHERES, mostInLeaf())) {
            return this;
        }
        int behind = ordered.linkToItem(before[start]);
        for (int item = start; item < end; item++) {
            int cell = boxes.numbers()[item];
            int length = Layout.SPHERE_STRIDE * spheresIn(cell);
            System.arraycopy(spheres, Layout.SPHERE_STRIDE * firsts[cell], ordered.floats(), behind, length);
            behind += length;
        }
        return ordered;
    }

    @Override
    public int hold(int start, int end, Bounds bounds) {
        bounds.holdBoxes(boxes.sides(), start, end);
        return end;
    }

    @Override
    public int split(int start, int end, int ancestors, Bounds bounds, Bins bins) {
        int axis = bounds.longestAxis();
        int middle = (start + end) / 2;
        if (ancestors < MOST_UNEVEN_ANCESTORS && bins.start(end - start, bounds.first(axis), bounds.last(axis))) {
            for (int item = start; item < end; item++) {
                boxes.add(item, spheresIn(boxes.numbers()[item]), axis, bins);
            }
            middle = boxes.part(start, end, axis, bins);
        }
        before[middle] = before[start];
        for (int item = start; item < middle; item++) {
            before[middle] += spheresIn(boxes.numbers()[item]);
        }
        return middle;
    }

    @Override
    public int linkToItem(int item) {
        return ordered.linkToItem(before[item]);
    }
}
