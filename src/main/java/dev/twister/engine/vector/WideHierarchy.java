package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;
import java.util.Arrays;

/**
 * The input's hierarchy with as many children a node as there are lanes, so that one test serves them all; kept while the
 * input's is the same. A child is a node, or a leaf of spheres, which begin a block of their own.
 */
final class WideHierarchy {
    /** Columns of a node: its children's low sides x, y, z and high sides x, y, z. */
    static final int BOX_STRIDE = 6 * Lanes.COUNT;

    /** What {@link #counts} says of a child that is a node. */
    static final int NODE = -1;

    /** The low sides of a box that nothing meets; its high ones are their negatives. */
    private static final float INSIDE_OUT = 1e36f;

    float[] boxes = {};

    /** Of each child, {@link Lanes#COUNT} a node: the node's number, or the place of the leaf's first block. */
    int[] links = {};

    /** Of each child: how many spheres are in the leaf, or {@link #NODE}. */
    int[] counts = {};

    /** In blocks, leaf by leaf. */
    final SphereColumns spheres = new SphereColumns();

    /** What becomes of a subtree of the source: a leaf, a node, or part of one. */
    private static final byte NEITHER = 0;

    private static final byte LEAF = 1;
    private static final byte INNER = 2;

    private static final int LEVEL = 32;

    /** Of each node of the source. */
    private byte[] kinds = {};

    private int nodes;
    private int blocks;
    private float[] source = {};
    private int sourceBodies;

    @SuppressWarnings("ReferenceEquality") // an input's arrays never change
    void take(FrameInput input) {
        if (source != input.hierarchy() || sourceBodies != input.bodies()) {
            source = input.hierarchy();
            sourceBodies = input.bodies();
            nodes = 0;
            blocks = 0;
            int root = Layout.root(sourceBodies);
            int places = (source.length - root) / Layout.NODE_STRIDE;
            if (kinds.length < places) {
                kinds = new byte[places];
            } else {
                Arrays.fill(kinds, NEITHER);
            }
            kinds[0] = group(root) < LEVEL ? LEAF : INNER;
            widen(root);
        }
    }

    /**
     * Says which subtrees of the source become leaves or nodes: bottom up, so that those at the bottom, of which there are
     * most, are the fullest.
     *
     * @return how high the subtree is, times {@link #LEVEL}, plus how many spheres (height 0) or children its topmost
     *     part has so far
     */
    private int group(int from) {
        int count = (int) source[from + Layout.NODE_SPHERES];
        int grouped = Math.min(count, Lanes.COUNT);
        if (count < 0) {
            int left = (int) source[from + Layout.NODE_LINK];
            int right = left + Layout.NODE_STRIDE;
            int first = group(left);
            int second = group(right);
            int level = Math.max(first, second) / LEVEL;
            boolean firstEnds = first / LEVEL < level;
            boolean secondEnds = second / LEVEL < level;
            int sum = (firstEnds ? 1 : first % LEVEL) + (secondEnds ? 1 : second % LEVEL);
            boolean full = sum > Lanes.COUNT;
            if (firstEnds || full) {
                kinds[place(left)] = first < LEVEL ? LEAF : INNER;
            }
            if (secondEnds || full) {
                kinds[place(right)] = second < LEVEL ? LEAF : INNER;
            }
            grouped = full ? (level + 1) * LEVEL + 2 : level * LEVEL + sum;
        }
        return grouped;
    }

    private int place(int from) {
        return (from - Layout.root(sourceBodies)) / Layout.NODE_STRIDE;
    }

    /** Makes a node of the leaves and nodes next below one of the source's nodes; returns its number. */
    private int widen(int top) {
        int node = nodes;
        nodes++;
        reserve(nodes);
        int first = node * Lanes.COUNT;
        links[first] = top;
        int end = kinds[place(top)] == INNER ? list(top, first) : first + 1;
        for (int at = first; at < first + Lanes.COUNT; at++) {
            writeBox(node * BOX_STRIDE + at - first, at < end ? links[at] : -1);
        }
        for (int at = first; at < first + Lanes.COUNT; at++) {
            finish(at, at < end ? links[at] : -1);
        }
        return node;
    }

    /** Lists those below a node of the source; returns the place behind the last. */
    private int list(int from, int at) {
        int next = at;
        int left = (int) source[from + Layout.NODE_LINK];
        for (int child = left; child <= left + Layout.NODE_STRIDE; child += Layout.NODE_STRIDE) {
            if (kinds[place(child)] == NEITHER) {
                next = list(child, next);
            } else {
                links[next] = child;
                next++;
            }
        }
        return next;
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
            float low = INSIDE_OUT;
            float high = -INSIDE_OUT;
            if (from >= 0) {
                float center = source[from + Layout.NODE_CENTER + axis];
                float half = source[from + Layout.NODE_HALF + axis];
                low = center - half;
                high = center + half;
            }
            boxes[at + axis * Lanes.COUNT] = low;
            boxes[at + (3 + axis) * Lanes.COUNT] = high;
        }
    }

    private void finish(int at, int from) {
        if (from < 0) {
            links[at] = 0;
            counts[at] = 0;
        } else if (kinds[place(from)] == INNER) {
            counts[at] = NODE;
            int child = widen(from);
            links[at] = child;
        } else {
            int first = firstSphere(from);
            counts[at] = lastSphere(from) - first;
            links[at] = blocks * SphereColumns.COLUMNS * Lanes.COUNT;
            copySpheres(first, counts[at]);
        }
    }

    /** Copies spheres that follow each other in the source to the next blocks. */
    private void copySpheres(int first, int count) {
        int end = blocks + (count + Lanes.COUNT - 1) / Lanes.COUNT;
        spheres.reserveBlocks(end);
        float[] to = spheres.values;
        for (int k = 0; k < count; k++) {
            int from = (first + k) * Layout.SPHERE_STRIDE;
            int place = (blocks + k / Lanes.COUNT) * spheres.step + k % Lanes.COUNT;
            to[place] = source[from + Layout.SPHERE_CENTER];
            to[place + SphereColumns.Y * Lanes.COUNT] = source[from + Layout.SPHERE_CENTER + 1];
            to[place + SphereColumns.Z * Lanes.COUNT] = source[from + Layout.SPHERE_CENTER + 2];
            to[place + SphereColumns.RADIUS * Lanes.COUNT] = source[from + Layout.SPHERE_RADIUS];
            to[place + SphereColumns.BODY * Lanes.COUNT] = source[from + Layout.SPHERE_BODY];
        }
        blocks = end;
    }

    private void reserve(int count) {
        if (links.length < count * Lanes.COUNT) {
            int room = Math.max(64, 2 * count);
            boxes = Arrays.copyOf(boxes, room * BOX_STRIDE);
            links = Arrays.copyOf(links, room * Lanes.COUNT);
            counts = Arrays.copyOf(counts, room * Lanes.COUNT);
        }
    }
}
