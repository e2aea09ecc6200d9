package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;
import java.util.Arrays;

/**
 * The input's hierarchy with as many children a node as there are lanes, so that one test serves them all; kept while the
 * input's is the same. A child is a node, or a leaf of spheres that lie side by side in the columns.
 */
final class WideHierarchy {
    /** Columns of a node: its children's centres x, y, z and half sides x, y, z. */
    static final int BOX_STRIDE = 6 * Lanes.COUNT;

    /** What {@link #spheres} says of a child that is a node. */
    static final int NODE = -1;

    /** A box that nothing meets. */
    private static final float INSIDE_OUT = -1e30f;

    float[] boxes = {};

    /** Of each child, {@link Lanes#COUNT} a node: the node's number, or the leaf's first place in the columns. */
    int[] links = {};

    /** Of each child: how many spheres are in the leaf, or {@link #NODE}. */
    int[] spheres = {};

    /** The spheres, leaf by leaf; as many blanks at the end as one load may reach too far. */
    float[] x = {};

    float[] y = {};
    float[] z = {};
    float[] radius = {};
    int[] bodies = {};

    private int nodes;
    private float[] source = {};
    private int sourceBodies;

    @SuppressWarnings("ReferenceEquality") // an input's arrays never change
    void take(FrameInput input) {
        if (source != input.hierarchy() || sourceBodies != input.bodies()) {
            source = input.hierarchy();
            sourceBodies = input.bodies();
            copySpheres();
            nodes = 0;
            widen(Layout.root(sourceBodies));
        }
    }

    private void copySpheres() {
        int count = sourceBodies - Layout.FIRST_SPHERE;
        if (x.length < count + Lanes.COUNT) {
            x = new float[count + Lanes.COUNT];
            y = new float[count + Lanes.COUNT];
            z = new float[count + Lanes.COUNT];
            radius = new float[count + Lanes.COUNT];
            bodies = new int[count + Lanes.COUNT];
        }
        for (int sphere = 0; sphere < count; sphere++) {
            int at = sphere * Layout.SPHERE_STRIDE;
            x[sphere] = source[at + Layout.SPHERE_CENTER];
            y[sphere] = source[at + Layout.SPHERE_CENTER + 1];
            z[sphere] = source[at + Layout.SPHERE_CENTER + 2];
            radius[sphere] = source[at + Layout.SPHERE_RADIUS];
            bodies[sphere] = (int) source[at + Layout.SPHERE_BODY];
        }
    }

    /** Makes a node of the largest boxes below one of the source's nodes; returns its number. */
    private int widen(int top) {
        int node = nodes;
        nodes++;
        reserve(nodes);
        int first = node * Lanes.COUNT;
        links[first] = top;
        int children = 1;
        int opened = source[top + Layout.NODE_SPHERES] < 0 ? first : -1;
        while (opened >= 0 && children < Lanes.COUNT) {
            int child = (int) source[links[opened] + Layout.NODE_LINK];
            links[opened] = child;
            links[first + children] = child + Layout.NODE_STRIDE;
            children++;
            opened = largestToOpen(first, children);
        }
        for (int child = 0; child < Lanes.COUNT; child++) {
            writeBox(node * BOX_STRIDE + child, child < children ? links[first + child] : -1);
        }
        for (int at = first; at < first + Lanes.COUNT; at++) {
            finish(at, at < first + children ? links[at] : -1);
        }
        return node;
    }

    /** Of a node's children in the source; -1 where all are leaves, or good as such. */
    private int largestToOpen(int first, int children) {
        int largest = -1;
        float most = -1;
        for (int at = first; at < first + children; at++) {
            int from = links[at];
            if (isOpened(from)) {
                float halfX = source[from + Layout.NODE_HALF];
                float halfY = source[from + Layout.NODE_HALF + 1];
                float halfZ = source[from + Layout.NODE_HALF + 2];
                float area = halfX * halfY + halfY * halfZ + halfZ * halfX;
                if (area > most) {
                    most = area;
                    largest = at;
                }
            }
        }
        return largest;
    }

    private boolean isOpened(int from) {
        return source[from + Layout.NODE_SPHERES] < 0 && lastSphere(from) - firstSphere(from) > Lanes.COUNT;
    }

    private int firstSphere(int from) {
        int node = from;
        while (source[node + Layout.NODE_SPHERES] < 0) {
            node = (int) source[node + Layout.NODE_LINK];
        }
        return (int) source[node + Layout.NODE_LINK] / Layout.SPHERE_STRIDE;
    }

    /** The place behind it. */
    private int lastSphere(int from) {
        int node = from;
        while (source[node + Layout.NODE_SPHERES] < 0) {
            node = (int) source[node + Layout.NODE_LINK] + Layout.NODE_STRIDE;
        }
        return (int) source[node + Layout.NODE_LINK] / Layout.SPHERE_STRIDE + (int) source[node + Layout.NODE_SPHERES];
    }

    private void writeBox(int at, int from) {
        for (int axis = 0; axis < 3; axis++) {
            boxes[at + axis * Lanes.COUNT] = from < 0 ? 0 : source[from + Layout.NODE_CENTER + axis];
            boxes[at + (3 + axis) * Lanes.COUNT] = from < 0 ? INSIDE_OUT : source[from + Layout.NODE_HALF + axis];
        }
    }

    private void finish(int at, int from) {
        if (from < 0) {
            links[at] = 0;
            spheres[at] = 0;
        } else if (isOpened(from)) {
            spheres[at] = NODE;
            int child = widen(from);
            links[at] = child;
        } else {
            links[at] = firstSphere(from);
            spheres[at] = lastSphere(from) - links[at];
        }
    }

    private void reserve(int count) {
        if (links.length < count * Lanes.COUNT) {
            int room = Math.max(64, 2 * count);
            boxes = Arrays.copyOf(boxes, room * BOX_STRIDE);
            links = Arrays.copyOf(links, room * Lanes.COUNT);
            spheres = Arrays.copyOf(spheres, room * Lanes.COUNT);
        }
    }
}
