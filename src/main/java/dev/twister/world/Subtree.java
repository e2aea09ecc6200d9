package dev.twister.world;

import dev.twister.kernel.Layout;
import java.util.concurrent.RecursiveAction;

/** Builds the nodes over some of the spheres; large ones let another thread build one of their halves. */
final class Subtree extends RecursiveAction {
    private static final long serialVersionUID = 1;

    /** Halves of fewer spheres are not worth another thread. */
    private static final int FEWEST_FOR_A_THREAD = 2048;

    /** From so many ancestors on, a node is split in the middle, so that the depth of all trees is bounded. */
    private static final int MOST_UNEVEN_ANCESTORS = 28;

    /** Of its extent and place, far above the rounding of centres and sides and of what the kernel does with them. */
    private static final float PLACE_MARGIN = 3.0e-7f;

    private static final float SIZE_MARGIN = 4.0e-6f;

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
     * @param node where the topmost goes
     * @param room where there is room for the others
     * @param ancestors how many nodes are above
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

    private void grow(int at, int free, int start, int end, int above) {
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

    /** Orders the spheres in two parts; returns how many are in the first. */
    private int split(int start, int end, int above) {
        float x = bounds.lastX - bounds.firstX;
        float y = bounds.lastY - bounds.firstY;
        float z = bounds.lastZ - bounds.firstZ;
        int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        float low = axis == 0 ? bounds.firstX : axis == 1 ? bounds.firstY : bounds.firstZ;
        float high = axis == 0 ? bounds.lastX : axis == 1 ? bounds.lastY : bounds.lastZ;
        int before = (end - start) / Layout.SPHERE_STRIDE / 2;
        boolean apart = high - low > 1e-6f * Math.max(Math.abs(low), Math.abs(high)) && high - low > 1e-30f;
        if (apart && above < MOST_UNEVEN_ANCESTORS) {
            bins.fill(hierarchy, start, end, axis, low, high);
            int border = bins.findBorder();
            before = bins.before;
            bins.part(hierarchy, start, end, border);
        }
        return before;
    }

    private void writeBox(int at, int spheres) {
        if (spheres > 0) {
            writeSides(at, bounds.lowX, bounds.highX);
            writeSides(at + 1, bounds.lowY, bounds.highY);
            writeSides(at + 2, bounds.lowZ, bounds.highZ);
            float all = hierarchy[at + Layout.NODE_HALF]
                    + hierarchy[at + Layout.NODE_HALF + 1]
                    + hierarchy[at + Layout.NODE_HALF + 2];
            hierarchy[at + Layout.NODE_HALF] += SIZE_MARGIN * all;
            hierarchy[at + Layout.NODE_HALF + 1] += SIZE_MARGIN * all;
            hierarchy[at + Layout.NODE_HALF + 2] += SIZE_MARGIN * all;
        }
    }

    private void writeSides(int at, float low, float high) {
        float center = 0.5f * (low + high);
        float farther = Math.max(Math.abs(low), Math.abs(high));
        hierarchy[at + Layout.NODE_CENTER] = center;
        hierarchy[at + Layout.NODE_HALF] = Math.max(high - center, center - low) + PLACE_MARGIN * farther;
    }
}
