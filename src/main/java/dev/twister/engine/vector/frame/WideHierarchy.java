package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.Optional;

/**
 * The input's hierarchy with as many children per node as there are lanes, so that one test covers all children. Reused
 * while the input's hierarchy is the same. A child is a node, or a leaf of spheres that starts a new block. All leaves
 * are at the same depth: in a level-by-level traversal nothing but leaves follows the first leaf.
 */
public final class WideHierarchy {
    /** Floats per node: its children's low sides x, y, z and high sides x, y, z, one column each. */
    public static final int BOX_STRIDE = 6 * Lanes.COUNT;

    /** Start of the root's boxes and links. */
    public static final int FIRST = Lanes.BORDER;

    /** The bits of a link from here on hold the number of a beam. */
    public static final int BEAM_SHIFT = 28;

    public static final int ROOT = 0;

    /** Flag of a link to a leaf. */
    private static final int LEAF = 1 << (BEAM_SHIFT - 1);

    private static final int NODE = LEAF - 1;

    /** In a leaf's link: position of the number of blocks less one, above the number of the first block. */
    private static final int BLOCKS_SHIFT = BEAM_SHIFT - 4;

    public static final int MORE_BLOCKS = 7;
    private static final int BLOCK = (1 << BLOCKS_SHIFT) - 1;

    /** Mask of a sphere's number, counted along the blocks, below the number of a beam. */
    public static final int SPHERE = (1 << BEAM_SHIFT) - 1;

    /** Low sides of an empty box; its high sides are their negatives. */
    public static final float INSIDE_OUT = 1e36f;

    /** {@link #BOX_STRIDE} floats per node, from {@link #FIRST} on. */
    public float[] boxes = {};

    /**
     * {@link Lanes#COUNT} links per node, from {@link #FIRST} on: a child node's number, or the encoded blocks of a
     * leaf.
     */
    public int[] links = {};

    /** The spheres in blocks, leaf by leaf; a leaf's last block is padded with spheres that are never hit. */
    public final SphereColumns spheres = new SphereColumns();

    /** Number of the root's children. */
    public int rootChildren;

    /** Coordinates of padding spheres, whose radius is 0: farther than any hit or light. */
    private static final float NOWHERE = 1e35f;

    /**
     * A subtree of the source becomes part of a leaf or node ({@code PART}), or one of a given height, with leaves at
     * 1.
     */
    private static final byte PART = 0;

    private static final int LEVEL = 32;

    /** The kind of each node of the source. */
    private byte[] kinds = {};

    private int nodes;
    private int blocks;
    private Optional<Bodies> taken = Optional.empty();
    private float[] source = {};
    private int sourceBodies;
    private int root;
    private int firstPlace;

    /** Takes the part of the input's hierarchy over the spheres that cast shadows. */
    public void take(FrameInput input) {
        boolean same = taken.filter(input.bodies()::hasHierarchyOf).isPresent();
        take(input, input.shadowRoot(), same);
    }

    /** Takes the part over the lights after the first; the input has such ones. */
    @SuppressWarnings("ReferenceEquality") // an input's arrays are immutable
    public void takeLights(FrameInput input) {
        boolean same = source == input.bodies().floats();
        take(input, input.lightRoot().orElseThrow(), same);
    }

    private void take(FrameInput input, int from, boolean sameHierarchy) {
        boolean same = sourceBodies == input.bodyCount() && sameHierarchy;
        taken = Optional.of(input.bodies());
        source = input.bodies().floats();
        if (!same) {
            sourceBodies = input.bodyCount();
            nodes = 0;
            blocks = 0;
            root = from;
            firstPlace = input.bodies().spheres();
            int places = (source.length - root) / Layout.NODE_STRIDE;
            if (kinds.length < places) {
                kinds = new byte[places];
            } else {
                Arrays.fill(kinds, PART);
            }
            kinds[0] = kind(group(root));
            widen(root, Math.max(kinds[0], 2));
            rootChildren = countRootChildren();
        }
    }

    /**
     * Decides bottom up which subtrees of the source become leaves or nodes, so that the lowest ones, which are the
     * most numerous, are the fullest.
     *
     * @return the subtree's height times {@link #LEVEL}, plus the number of spheres (at height 0) or children in its
     *     topmost part so far
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
                kinds[place(left)] = kind(first);
            }
            if (secondEnds || full) {
                kinds[place(right)] = kind(second);
            }
            grouped = full ? (level + 1) * LEVEL + 2 : level * LEVEL + sum;
        }
        return grouped;
    }

    private int countRootChildren() {
        int count = 0;
        while (count < Lanes.COUNT && boxes[FIRST + count] <= boxes[FIRST + 3 * Lanes.COUNT + count]) {
            count++;
        }
        return count;
    }

    private static byte kind(int grouped) {
        return (byte) (1 + grouped / LEVEL);
    }

    private int place(int from) {
        return (from - root) / Layout.NODE_STRIDE;
    }

    /**
     * Creates a node from the leaves and nodes below a node of the source; where that is lower than required, the new
     * node has it as its only child. Returns the new node's number.
     */
    private int widen(int top, int height) {
        int node = nodes;
        nodes++;
        reserve(nodes);
        int first = FIRST + node * Lanes.COUNT;
        links[first] = top;
        int end = kinds[place(top)] == height ? list(top, first) : first + 1;
        for (int at = first; at < first + Lanes.COUNT; at++) {
            writeBox(FIRST + node * BOX_STRIDE + at - first, at < end ? links[at] : -1);
        }
        for (int at = first; at < first + Lanes.COUNT; at++) {
            int link = at < end ? link(links[at], height - 1) : 0;
            links[at] = link;
        }
        return node;
    }

    /** Lists the leaves and nodes below a node of the source; returns the place after the last. */
    private int list(int from, int at) {
        int next = at;
        int left = (int) source[from + Layout.NODE_LINK];
        for (int child = left; child <= left + Layout.NODE_STRIDE; child += Layout.NODE_STRIDE) {
            if (kinds[place(child)] == PART) {
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
        return number(node);
    }

    /** The place after the subtree's last sphere. */
    private int lastSphere(int from) {
        int node = from;
        while (source[node + Layout.NODE_SPHERES] < 0) {
            node = (int) source[node + Layout.NODE_LINK] + Layout.NODE_STRIDE;
        }
        return number(node) + (int) source[node + Layout.NODE_SPHERES];
    }

    /** The number of a leaf's first sphere, in the order of the leaves. */
    private int number(int leaf) {
        return ((int) source[leaf + Layout.NODE_LINK] - firstPlace) / Layout.SPHERE_STRIDE;
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

    private int link(int from, int height) {
        int link;
        if (height > 1) {
            link = widen(from, height);
        } else {
            int first = firstSphere(from);
            int block = blocks;
            copySpheres(first, lastSphere(from) - first);
            link = LEAF | (blocks - block - 1) << BLOCKS_SHIFT | block;
        }
        return link;
    }

    /** Whether all spheres are in the first block, where a traversal would only take time. */
    public boolean isOneBlock() {
        return blocks == 1;
    }

    /** Whether a node's children are leaves. */
    public boolean isAboveLeaves(int node) {
        return isLeaf(links[FIRST + node * Lanes.COUNT]);
    }

    public static boolean isLeaf(int link) {
        return (link & LEAF) != 0;
    }

    /** The node's number in a link. */
    public static int node(int link) {
        return link & NODE;
    }

    /** The place of a leaf's first block. */
    public static int firstBlock(int link) {
        return SphereColumns.FIRST + (link & BLOCK) * SphereColumns.COLUMNS * Lanes.COUNT;
    }

    /** The number of a leaf's first block. */
    public static int block(int link) {
        return link & BLOCK;
    }

    public static int blocks(int link) {
        return 1 + (link >>> BLOCKS_SHIFT & MORE_BLOCKS);
    }

    /** Copies consecutive spheres of the source to the next blocks. */
    private void copySpheres(int first, int count) {
        int end = blocks + Math.max(1, (count + Lanes.COUNT - 1) / Lanes.COUNT);
        spheres.reserveBlocks(end);
        float[] to = spheres.values;
        for (int block = blocks; block < end; block++) {
            int at = SphereColumns.FIRST + block * spheres.step;
            Arrays.fill(to, at, at + SphereColumns.RADIUS * Lanes.COUNT, NOWHERE);
            Arrays.fill(to, at + SphereColumns.RADIUS * Lanes.COUNT, at + spheres.step, 0f);
        }
        for (int k = 0; k < count; k++) {
            int from = firstPlace + (first + k) * Layout.SPHERE_STRIDE;
            int place = SphereColumns.FIRST + (blocks + k / Lanes.COUNT) * spheres.step + k % Lanes.COUNT;
            to[place] = source[from];
            to[place + SphereColumns.Y * Lanes.COUNT] = source[from + 1];
            to[place + SphereColumns.Z * Lanes.COUNT] = source[from + 2];
            to[place + SphereColumns.RADIUS * Lanes.COUNT] = source[from + Layout.SPHERE_RADIUS];
            to[place + SphereColumns.BODY * Lanes.COUNT] = source[from + Layout.SPHERE_BODY];
        }
        blocks = end;
    }

    private void reserve(int count) {
        if (links.length < FIRST + count * Lanes.COUNT) {
            int room = Math.max(64, 2 * count);
            boxes = Arrays.copyOf(boxes, FIRST + room * BOX_STRIDE);
            links = Arrays.copyOf(links, FIRST + room * Lanes.COUNT);
        }
    }
}
