package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import dev.twister.kernel.NodeBox;
import dev.twister.kernel.Shadow;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Box tests of a packet's cones: {@link NodeBox}. A cone is replaced by the wider one of all directions whose
 * components lie between a least and a greatest one.
 */
final class ConeLanes {
    /** Growth of boxes relative to their distance. */
    private static final float GROWTH = 2f * NodeBox.GROWTH;

    /** Rounding of a direction's component relative to the terms of its sum. */
    private static final float ROUNDING = 2.0e-6f;

    private ConeLanes() {}

    /**
     * Writes the cones in the coordinates of a hierarchy.
     *
     * @param rows array with the rows of the transform to those coordinates
     * @param first place of the first row
     * @param lanes one bit per lane with a cone
     */
    static void aim(Tile tile, int at, ShadowColumns columns, PacketCones cones, float[] rows, int first, long lanes) {
        float[] t = tile.values;
        float[] c = cones.values;
        float[] frame = columns.frame;
        float[] boxes = cones.boxes;
        FloatVector farthest = FloatVector.zero(Lanes.FLOATS);
        float halves = 0f;
        for (int axis = 0; axis < 3; axis++) {
            int row = first + 4 * axis;
            int column = axis * Lanes.COUNT;
            FloatVector distance = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.LIGHT_DISTANCE);
            FloatVector point = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.POINT_X)
                    .mul(rows[row])
                    .add(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.POINT_Y)
                            .mul(rows[row + 1]))
                    .add(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.POINT_Z)
                            .mul(rows[row + 2]))
                    .add(rows[row + 3]);
            FloatVector x = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_X)
                    .mul(distance)
                    .mul(rows[row]);
            FloatVector y = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Y)
                    .mul(distance)
                    .mul(rows[row + 1]);
            FloatVector z = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Z)
                    .mul(distance)
                    .mul(rows[row + 2]);
            FloatVector u = FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.U_Y)
                    .mul(rows[row + 1])
                    .add(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.U_Z)
                            .mul(rows[row + 2]));
            FloatVector w = FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.W_X)
                    .mul(rows[row])
                    .add(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.W_Y)
                            .mul(rows[row + 1]))
                    .add(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.W_Z)
                            .mul(rows[row + 2]));
            FloatVector along = x.add(y).add(z);
            FloatVector spread = u.mul(u)
                    .add(w.mul(w))
                    .sqrt()
                    .mul(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.SCALE))
                    .mul(distance)
                    .mul(Shadow.RELATIVE_MARGIN)
                    .add(x.abs().add(y.abs()).add(z.abs()).mul(ROUNDING));
            point.intoArray(c, PacketCones.POINT + column);
            along.sub(spread).intoArray(c, PacketCones.LEAST + column);
            along.add(spread).intoArray(c, PacketCones.GREATEST + column);
            farthest = farthest.add(
                    point.sub(boxes[cones.nodes + Layout.NODE_CENTER + axis]).abs());
            halves += boxes[cones.nodes + Layout.NODE_HALF + axis];
        }
        int bits = FloatVector.zero(Lanes.FLOATS)
                .blend(farthest, VectorMask.fromLong(Lanes.FLOATS, lanes))
                .reinterpretAsInts()
                .reduceLanes(VectorOperators.MAX);
        cones.growth = GROWTH * (Float.intBitsToFloat(bits) + halves);
        cones.lanes = lanes;
        invert(tile, cones);
    }

    /** Replaces the directions' limits by their inverses, and writes the sides. */
    static void invert(Tile tile, PacketCones cones) {
        float[] c = cones.values;
        for (int column = 0; column < 3 * Lanes.COUNT; column += Lanes.COUNT) {
            FloatVector least = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.LEAST + column);
            FloatVector greatest = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.GREATEST + column);
            VectorMask<Float> falls = least.compare(VectorOperators.LT, 0f);
            VectorMask<Float> onlyFalls = greatest.compare(VectorOperators.LT, 0f);
            FloatVector tiny = FloatVector.broadcast(Lanes.FLOATS, NodeBox.TINY).blend(-NodeBox.TINY, falls);
            FloatVector other =
                    FloatVector.broadcast(Lanes.FLOATS, NodeBox.TINY).blend(-NodeBox.TINY, onlyFalls);
            FloatVector.broadcast(Lanes.FLOATS, 1f)
                    .div(least.blend(tiny, least.abs().compare(VectorOperators.LE, NodeBox.TINY)))
                    .intoArray(c, PacketCones.LEAST + column);
            FloatVector.broadcast(Lanes.FLOATS, 1f)
                    .div(greatest.blend(other, greatest.abs().compare(VectorOperators.LE, NodeBox.TINY)))
                    .intoArray(c, PacketCones.GREATEST + column);
            FloatVector.broadcast(Lanes.FLOATS, -Float.MAX_VALUE)
                    .blend(Float.MAX_VALUE, falls)
                    .intoArray(c, PacketCones.LEAST_SIDE + column);
            FloatVector.broadcast(Lanes.FLOATS, Float.MAX_VALUE)
                    .blend(-Float.MAX_VALUE, onlyFalls)
                    .intoArray(c, PacketCones.GREATEST_SIDE + column);
        }
    }

    /** Continues to the next leaf whose box any cone meets; returns its place, or {@link Layout#NO_NODE}. */
    static int nextLeaf(Tile tile, PacketCones cones) {
        float[] boxes = cones.boxes;
        int[] stack = cones.stack;
        float growth = cones.growth;
        int waiting = cones.waiting;
        int leaf = Layout.NO_NODE;
        while (leaf == Layout.NO_NODE && waiting > 0) {
            waiting--;
            int node = stack[waiting];
            float x = boxes[node + Layout.NODE_CENTER];
            float y = boxes[node + Layout.NODE_CENTER + 1];
            float z = boxes[node + Layout.NODE_CENTER + 2];
            float halfX = boxes[node + Layout.NODE_HALF] + growth;
            float halfY = boxes[node + Layout.NODE_HALF + 1] + growth;
            float halfZ = boxes[node + Layout.NODE_HALF + 2] + growth;
            if (meet(cones, x - halfX, x + halfX, y - halfY, y + halfY, z - halfZ, z + halfZ) != 0L) {
                if (boxes[node + Layout.NODE_SPHERES] < 0f) {
                    int child = cones.nodes + Layout.NODE_STRIDE * (int) boxes[node + Layout.NODE_LINK];
                    stack[waiting] = child;
                    stack[waiting + 1] = child + Layout.NODE_STRIDE;
                    waiting += 2;
                } else {
                    leaf = node;
                }
            }
        }
        cones.waiting = waiting;
        return leaf;
    }

    /** Whether any cone meets the box of a triangle. */
    static boolean meetTriangle(Tile tile, PacketCones cones, int at) {
        float[] m = cones.boxes;
        float growth = cones.growth;
        float lowX = Math.min(Math.min(m[at], m[at + 3]), m[at + 6]) - growth;
        float lowY = Math.min(Math.min(m[at + 1], m[at + 4]), m[at + 7]) - growth;
        float lowZ = Math.min(Math.min(m[at + 2], m[at + 5]), m[at + 8]) - growth;
        float highX = Math.max(Math.max(m[at], m[at + 3]), m[at + 6]) + growth;
        float highY = Math.max(Math.max(m[at + 1], m[at + 4]), m[at + 7]) + growth;
        float highZ = Math.max(Math.max(m[at + 2], m[at + 5]), m[at + 8]) + growth;
        return meet(cones, lowX, highX, lowY, highY, lowZ, highZ) != 0L;
    }

    /**
     * One bit per cone that meets a box. Positive floats compare like their bits, and the order of negative values does
     * not matter, so minima and maxima are taken as ints.
     */
    private static long meet(
            PacketCones cones, float lowX, float highX, float lowY, float highY, float lowZ, float highZ) {
        float[] c = cones.values;
        IntVector in = IntVector.zero(Lanes.INTS);
        IntVector out =
                FloatVector.broadcast(Lanes.FLOATS, Shadow.RELATIVE_MARGIN).reinterpretAsInts();
        FloatVector point = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.POINT);
        IntVector at = FloatVector.broadcast(Lanes.FLOATS, highX)
                .sub(point)
                .mul(FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.LEAST))
                .reinterpretAsInts();
        IntVector side =
                FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.LEAST_SIDE).reinterpretAsInts();
        in = in.max(at.min(side));
        out = out.min(at.max(side));
        at = FloatVector.broadcast(Lanes.FLOATS, lowX)
                .sub(point)
                .mul(FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.GREATEST))
                .reinterpretAsInts();
        side = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.GREATEST_SIDE).reinterpretAsInts();
        in = in.max(at.min(side));
        out = out.min(at.max(side));
        point = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.POINT + Lanes.COUNT);
        at = FloatVector.broadcast(Lanes.FLOATS, highY)
                .sub(point)
                .mul(FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.LEAST + Lanes.COUNT))
                .reinterpretAsInts();
        side = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.LEAST_SIDE + Lanes.COUNT)
                .reinterpretAsInts();
        in = in.max(at.min(side));
        out = out.min(at.max(side));
        at = FloatVector.broadcast(Lanes.FLOATS, lowY)
                .sub(point)
                .mul(FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.GREATEST + Lanes.COUNT))
                .reinterpretAsInts();
        side = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.GREATEST_SIDE + Lanes.COUNT)
                .reinterpretAsInts();
        in = in.max(at.min(side));
        out = out.min(at.max(side));
        point = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.POINT + 2 * Lanes.COUNT);
        at = FloatVector.broadcast(Lanes.FLOATS, highZ)
                .sub(point)
                .mul(FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.LEAST + 2 * Lanes.COUNT))
                .reinterpretAsInts();
        side = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.LEAST_SIDE + 2 * Lanes.COUNT)
                .reinterpretAsInts();
        in = in.max(at.min(side));
        out = out.min(at.max(side));
        at = FloatVector.broadcast(Lanes.FLOATS, lowZ)
                .sub(point)
                .mul(FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.GREATEST + 2 * Lanes.COUNT))
                .reinterpretAsInts();
        side = FloatVector.fromArray(Lanes.FLOATS, c, PacketCones.GREATEST_SIDE + 2 * Lanes.COUNT)
                .reinterpretAsInts();
        in = in.max(at.min(side));
        out = out.min(at.max(side));
        return in.compare(VectorOperators.LE, out).toLong() & cones.lanes;
    }
}
