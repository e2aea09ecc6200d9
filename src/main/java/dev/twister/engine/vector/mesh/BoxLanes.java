package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import dev.twister.kernel.NodeBox;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Box tests of a packet's rays: {@link NodeBox#entry}. */
final class BoxLanes {
    /**
     * Growth of boxes relative to their distance: that of {@link NodeBox}, and more because distances here are
     * differences of two rounded products.
     */
    private static final float GROWTH = 1.5f * NodeBox.GROWTH;

    /** Additional growth relative to the origin's coordinates. */
    private static final float ROUNDING = 0.25f;

    private BoxLanes() {}

    /**
     * Writes the inverse directions and their products with the origins, the growth of all boxes, and the near sides.
     * One growth serves all rays: it is derived from the farthest point of the root's box.
     */
    static void aim(Tile tile, PacketWalk walk) {
        float[] r = walk.rays;
        float[] boxes = walk.boxes;
        long takesPart = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.END)
                .compare(VectorOperators.GE, 0f)
                .toLong();
        FloatVector farthest = FloatVector.zero(Lanes.FLOATS);
        walk.mixed = false;
        float halves = 0f;
        for (int axis = 0; axis < 3; axis++) {
            int column = axis * Lanes.COUNT;
            FloatVector origin = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN + column);
            FloatVector direction = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DIRECTION + column);
            VectorMask<Float> falls = direction.compare(VectorOperators.LT, 0f);
            FloatVector tiny = FloatVector.broadcast(Lanes.FLOATS, NodeBox.TINY).blend(-NodeBox.TINY, falls);
            FloatVector inverse = FloatVector.broadcast(Lanes.FLOATS, 1f)
                    .div(direction.blend(tiny, direction.abs().compare(VectorOperators.LE, NodeBox.TINY)));
            inverse.intoArray(r, PacketWalk.INVERSE + column);
            origin.mul(inverse).neg().intoArray(r, PacketWalk.BEHIND + column);
            farthest = farthest.add(
                    origin.sub(boxes[walk.nodes + Layout.NODE_CENTER + axis]).abs());
            farthest = farthest.add(origin.abs().mul(ROUNDING));
            halves += boxes[walk.nodes + Layout.NODE_HALF + axis];
            long falling = falls.toLong() & takesPart;
            walk.side[axis] = falling == 0L ? 1f : -1f;
            walk.mixed |= falling != 0L && falling != takesPart;
        }
        int bits = FloatVector.zero(Lanes.FLOATS)
                .blend(farthest, VectorMask.fromLong(Lanes.FLOATS, takesPart))
                .reinterpretAsInts()
                .reduceLanes(VectorOperators.MAX);
        walk.growth = GROWTH * (Float.intBitsToFloat(bits) + halves);
    }

    /**
     * Continues to the next leaf whose box any ray may meet before its end. Both children of a node are tested
     * together. Positive floats compare like their bits, and the order of negative values does not matter, so minima
     * and maxima are taken as ints.
     *
     * @return the leaf's place, or {@link Layout#NO_NODE} if there is none
     */
    static int nextLeaf(Tile tile, PacketWalk walk) {
        float[] r = walk.rays;
        float[] boxes = walk.boxes;
        int[] stack = walk.stack;
        int[] entries = walk.entries;
        // A waiting node whose smallest entry lies beyond every ray's end is skipped.
        int farthest = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.END)
                .reinterpretAsInts()
                .reduceLanes(VectorOperators.MAX);
        float growth = walk.growth;
        float sideX = walk.side[0];
        float sideY = walk.side[1];
        float sideZ = walk.side[2];
        boolean mixed = walk.mixed;
        int waiting = walk.waiting;
        int leaf = Layout.NO_NODE;
        int first = walk.start;
        int second = first;
        while (leaf == Layout.NO_NODE && (first != Layout.NO_NODE || waiting > 0)) {
            int node;
            if (first == Layout.NO_NODE) {
                waiting--;
                node = entries[waiting] <= farthest ? stack[waiting] : Layout.NO_NODE;
            } else {
                FloatVector inverse = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.INVERSE);
                FloatVector behind = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.BEHIND);
                float center = boxes[first + Layout.NODE_CENTER];
                float half = (boxes[first + Layout.NODE_HALF] + growth) * sideX;
                IntVector nearX =
                        Lanes.fma(inverse, Lanes.all(center - half), behind).reinterpretAsInts();
                IntVector farX =
                        Lanes.fma(inverse, Lanes.all(center + half), behind).reinterpretAsInts();
                center = boxes[second + Layout.NODE_CENTER];
                half = (boxes[second + Layout.NODE_HALF] + growth) * sideX;
                IntVector otherNearX =
                        Lanes.fma(inverse, Lanes.all(center - half), behind).reinterpretAsInts();
                IntVector otherFarX =
                        Lanes.fma(inverse, Lanes.all(center + half), behind).reinterpretAsInts();
                inverse = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.INVERSE + Lanes.COUNT);
                behind = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.BEHIND + Lanes.COUNT);
                center = boxes[first + Layout.NODE_CENTER + 1];
                half = (boxes[first + Layout.NODE_HALF + 1] + growth) * sideY;
                IntVector nearY =
                        Lanes.fma(inverse, Lanes.all(center - half), behind).reinterpretAsInts();
                IntVector farY =
                        Lanes.fma(inverse, Lanes.all(center + half), behind).reinterpretAsInts();
                center = boxes[second + Layout.NODE_CENTER + 1];
                half = (boxes[second + Layout.NODE_HALF + 1] + growth) * sideY;
                IntVector otherNearY =
                        Lanes.fma(inverse, Lanes.all(center - half), behind).reinterpretAsInts();
                IntVector otherFarY =
                        Lanes.fma(inverse, Lanes.all(center + half), behind).reinterpretAsInts();
                inverse = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.INVERSE + 2 * Lanes.COUNT);
                behind = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.BEHIND + 2 * Lanes.COUNT);
                center = boxes[first + Layout.NODE_CENTER + 2];
                half = (boxes[first + Layout.NODE_HALF + 2] + growth) * sideZ;
                IntVector nearZ =
                        Lanes.fma(inverse, Lanes.all(center - half), behind).reinterpretAsInts();
                IntVector farZ =
                        Lanes.fma(inverse, Lanes.all(center + half), behind).reinterpretAsInts();
                center = boxes[second + Layout.NODE_CENTER + 2];
                half = (boxes[second + Layout.NODE_HALF + 2] + growth) * sideZ;
                IntVector otherNearZ =
                        Lanes.fma(inverse, Lanes.all(center - half), behind).reinterpretAsInts();
                IntVector otherFarZ =
                        Lanes.fma(inverse, Lanes.all(center + half), behind).reinterpretAsInts();
                IntVector near;
                IntVector far;
                IntVector otherNear;
                IntVector otherFar;
                if (mixed) {
                    near = nearX.min(farX).max(nearY.min(farY)).max(nearZ.min(farZ));
                    far = nearX.max(farX).min(nearY.max(farY)).min(nearZ.max(farZ));
                    otherNear = otherNearX
                            .min(otherFarX)
                            .max(otherNearY.min(otherFarY))
                            .max(otherNearZ.min(otherFarZ));
                    otherFar = otherNearX
                            .max(otherFarX)
                            .min(otherNearY.max(otherFarY))
                            .min(otherNearZ.max(otherFarZ));
                } else {
                    near = nearX.max(nearY).max(nearZ);
                    far = farX.min(farY).min(farZ);
                    otherNear = otherNearX.max(otherNearY).max(otherNearZ);
                    otherFar = otherFarX.min(otherFarY).min(otherFarZ);
                }
                IntVector end =
                        FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.END).reinterpretAsInts();
                near = near.max(0);
                otherNear = otherNear.max(0);
                VectorMask<Integer> lanes = near.compare(VectorOperators.LE, far.min(end));
                VectorMask<Integer> otherLanes = otherNear.compare(VectorOperators.LE, otherFar.min(end));
                boolean met = lanes.anyTrue();
                boolean otherMet = otherLanes.anyTrue() && first != second;
                float apart = (boxes[second] - boxes[first]) * walk.towardsX
                        + (boxes[second + 1] - boxes[first + 1]) * walk.towardsY
                        + (boxes[second + 2] - boxes[first + 2]) * walk.towardsZ;
                node = met ? first : otherMet ? second : Layout.NO_NODE;
                if (met && otherMet) {
                    boolean swapped = apart < 0f;
                    node = swapped ? second : first;
                    stack[waiting] = swapped ? first : second;
                    entries[waiting] = IntVector.broadcast(Lanes.INTS, Integer.MAX_VALUE)
                            .blend(swapped ? near : otherNear, swapped ? lanes : otherLanes)
                            .reduceLanes(VectorOperators.MIN);
                    waiting++;
                }
            }
            first = Layout.NO_NODE;
            if (node != Layout.NO_NODE && boxes[node + Layout.NODE_SPHERES] < 0f) {
                first = walk.nodes + Layout.NODE_STRIDE * (int) boxes[node + Layout.NODE_LINK];
                second = first + Layout.NODE_STRIDE;
            } else {
                leaf = node;
            }
        }
        walk.waiting = waiting;
        walk.start = Layout.NO_NODE;
        return leaf;
    }
}
