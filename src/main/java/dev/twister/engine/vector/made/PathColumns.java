package dev.twister.engine.vector.made;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Views;
import dev.twister.world.FrameInput;

/**
 * What made lanes work on: packets of {@link Lanes#COUNT} paths. A packet's values are columns: the path's floats in
 * the order of {@link dev.twister.kernel.Layout}, then others, ints, masks as bits, and a scratch per path. Columns are
 * 16 wide for every number of lanes; narrower packets lie side by side.
 */
public final class PathColumns {
    /** Distance between columns. */
    public static final int WIDTH = 16;

    /** The mask of the lanes that run. */
    public static final int ACTIVE = 0;

    /** Int columns: the result, then the method's int parameters. */
    public static final int RESULT = 0;

    public static final int FIRST_PARAMETER = 1;

    private static final int BLOCK = WIDTH / Lanes.COUNT;

    public final float[] floats;
    public final int[] ints;
    public final long[] masks;
    public final float[] scratch;

    /** Lists of packets, for the control flow of made lanes. */
    public final int[][] lists;

    /** The kernel's arguments. */
    float[] frame = {};

    float[] bodies = {};
    float[] looks = {};
    float[] meshes = {};
    float[] images = {};
    int variant;

    private int endOfLayers;

    private final int floatStride;
    private final int intStride;
    private final int maskStride;
    private final int scratchStride;

    /**
     * Columns for a number of paths.
     *
     * @param paths a multiple of {@link #WIDTH}
     */
    public PathColumns(int paths) {
        this(paths, ColumnCounts.FLOATS, ColumnCounts.INTS, ColumnCounts.MASKS, ColumnCounts.LISTS);
    }

    /** As above, with numbers of columns of each kind and of lists. */
    PathColumns(int paths, int floatColumns, int intColumns, int maskColumns, int listCount) {
        int blocks = paths / WIDTH;
        int packets = paths / Lanes.COUNT;
        floatStride = WIDTH * floatColumns;
        intStride = WIDTH * intColumns;
        maskStride = maskColumns;
        scratchStride = WIDTH * ColumnCounts.SCRATCH;
        floats = new float[Lanes.BORDER + blocks * floatStride];
        ints = new int[Lanes.BORDER + blocks * intStride];
        masks = new long[packets * maskStride];
        scratch = new float[blocks * scratchStride];
        lists = new int[listCount][packets];
    }

    /** Takes over a frame. */
    public void take(FrameInput input, int frameVariant) {
        frame = input.view().frame();
        bodies = input.bodies().floats();
        looks = input.bodies().looks();
        meshes = input.bodies().meshes();
        images = input.images();
        variant = frameVariant;
        int layers = Views.isLayered(variant) != 0 ? (int) frame[Layout.LIGHT_LAYERS] : 0;
        endOfLayers = Layout.SCRATCH_LAYERS + 3 * layers;
    }

    /** Place in {@link #floats} of a path's float. */
    public int floatAt(int path, int column) {
        return Lanes.BORDER + path / WIDTH * floatStride + WIDTH * column + path % WIDTH;
    }

    /** Place in {@link #ints} of a path's int. */
    public int intAt(int path, int column) {
        return Lanes.BORDER + path / WIDTH * intStride + WIDTH * column + path % WIDTH;
    }

    /** Place in {@link #scratch} of a float of a path's scratch. */
    public int scratchAt(int path, int place) {
        return path / WIDTH * scratchStride + WIDTH * place + path % WIDTH;
    }

    /** Sets which lanes of a packet run, as bits. */
    public void activate(int packet, long lanes) {
        masks[packet * maskStride + ACTIVE] = lanes;
    }

    /** Clears what a path carries from ray to ray, the sums over a pixel's samples included. */
    public void clear(int path) {
        for (int column : ColumnCounts.STATE) {
            floats[floatAt(path, column)] = 0f;
        }
        for (int place = Layout.SCRATCH_LAYERS; place < endOfLayers; place++) {
            scratch[scratchAt(path, place)] = 0f;
        }
    }

    /** Exchanges two paths. */
    public void swap(int a, int b) {
        for (int column : ColumnCounts.STATE) {
            swap(floats, floatAt(a, column), floatAt(b, column));
        }
        for (int place = Layout.SCRATCH_LAYERS; place < endOfLayers; place++) {
            swap(scratch, scratchAt(a, place), scratchAt(b, place));
        }
    }

    private static void swap(float[] values, int a, int b) {
        float value = values[a];
        values[a] = values[b];
        values[b] = value;
    }

    /** Copies what a path carries to the kernel's path and scratch. */
    public void copy(int path, float[] kernelPath, float[] kernelScratch) {
        for (int column : ColumnCounts.STATE) {
            kernelPath[column] = floats[floatAt(path, column)];
        }
        for (int place = Layout.SCRATCH_LAYERS; place < endOfLayers; place++) {
            kernelScratch[place] = scratch[scratchAt(path, place)];
        }
    }

    int firstFloat(int packet) {
        return Lanes.BORDER + packet / BLOCK * floatStride + packet % BLOCK * Lanes.COUNT;
    }

    int firstInt(int packet) {
        return Lanes.BORDER + packet / BLOCK * intStride + packet % BLOCK * Lanes.COUNT;
    }

    int firstScratch(int packet) {
        return packet / BLOCK * scratchStride + packet % BLOCK * Lanes.COUNT;
    }

    int firstMask(int packet) {
        return packet * maskStride;
    }

    static int copy(int[] list, int count, int[] to) {
        System.arraycopy(list, 0, to, 0, count);
        return count;
    }

    /** Lists the packets whose mask has lanes; the lists may be the same one. */
    int filter(long[] packetMasks, int mask, int[] list, int count, int[] to) {
        int kept = 0;
        for (int k = 0; k < count; k++) {
            int packet = list[k];
            to[kept] = packet;
            kept += packetMasks[packet * maskStride + mask] == 0L ? 0 : 1;
        }
        return kept;
    }
}
