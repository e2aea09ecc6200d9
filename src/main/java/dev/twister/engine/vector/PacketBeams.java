package dev.twister.engine.vector;

import dev.twister.kernel.NodeBox;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * A {@link Beam} for each lane of a packet: its ray, or its point's lines to the light's disc. All are made at once; then
 * each is tested against as many boxes as there are lanes.
 */
final class PacketBeams {
    /** What a plane's t is made less or greater by, as a part of the origin's: it is rounded by two units of 2^-24. */
    private static final float ROUNDING = 2e-7f;

    // Three columns each, one an axis: what makes the t of the near side, of the far one, and of a second near one.
    private static final int AXES = 3 * Lanes.COUNT;
    private static final int NEAR_SCALE = 0;
    private static final int NEAR_ADDITION = AXES;
    private static final int FAR_SCALE = 2 * AXES;
    private static final int FAR_ADDITION = 3 * AXES;
    private static final int SECOND_SCALE = 4 * AXES;
    private static final int SECOND_ADDITION = 5 * AXES;

    /** Metres a metre of t, lowest and highest. */
    private static final int LOW = 6 * AXES;

    private static final int HIGH = 7 * AXES;

    /** The t at which the lines end, one column. */
    private static final int END = 8 * AXES;

    private final float[] facts = new float[END + Lanes.COUNT];

    /** One bit a lane where the slopes along an axis are less than 0: the near sides are the high ones. */
    private final long[] falls = new long[3];

    /** One bit a lane whose slopes differ in sign along any axis. */
    private long straddles;

    /** The packet's rays, as far as the closest hits so far. */
    void holdRays(float[] t, int at) {
        for (int axis = 0; axis < 3; axis++) {
            FloatVector direction = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_X + axis * Tile.SIZE);
            direction.sub(Beam.SPREAD).intoArray(facts, LOW + axis * Lanes.COUNT);
            direction.add(Beam.SPREAD).intoArray(facts, HIGH + axis * Lanes.COUNT);
        }
        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE)
                .mul(1f + Beam.SPREAD)
                .min(Beam.EVERYWHERE)
                .intoArray(facts, END);
        finish(t, at + Tile.ORIGIN_X);
    }

    /** The lines from the packet's points to the light's disc, as far as its outermost sample. */
    void holdLines(float[] t, int at) {
        FloatVector distance = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.LIGHT_DISTANCE);
        FloatVector radius =
                FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISC_TANGENT).mul(distance);
        FloatVector spread = distance.add(radius).mul(Beam.DISC_SPREAD);
        for (int axis = 0; axis < 3; axis++) {
            FloatVector along = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_X + axis * Tile.SIZE);
            FloatVector reach =
                    along.mul(along).neg().add(1f).max(0f).sqrt().mul(radius).add(spread);
            FloatVector middle = along.mul(distance);
            middle.sub(reach).intoArray(facts, LOW + axis * Lanes.COUNT);
            middle.add(reach).intoArray(facts, HIGH + axis * Lanes.COUNT);
        }
        FloatVector.broadcast(Lanes.FLOATS, 1f + Beam.DISC_SPREAD).intoArray(facts, END);
        finish(t, at + Tile.POINT_X);
    }

    private void finish(float[] t, int origin) {
        straddles = 0;
        for (int axis = 0; axis < 3; axis++) {
            findPlanes(t, origin + axis * Tile.SIZE, axis);
        }
    }

    /** As {@link Slab#set}. */
    private void findPlanes(float[] t, int from, int axis) {
        int column = axis * Lanes.COUNT;
        FloatVector origin = FloatVector.fromArray(Lanes.FLOATS, t, from);
        FloatVector low = FloatVector.fromArray(Lanes.FLOATS, facts, LOW + column);
        FloatVector high = FloatVector.fromArray(Lanes.FLOATS, facts, HIGH + column);
        VectorMask<Float> falling = high.compare(VectorOperators.LE, 0f);
        VectorMask<Float> straddling = high.compare(VectorOperators.GT, 0f).and(low.compare(VectorOperators.LT, 0f));
        FloatVector one = FloatVector.broadcast(Lanes.FLOATS, 1f);
        FloatVector tiny = FloatVector.broadcast(Lanes.FLOATS, NodeBox.TINY);
        FloatVector lowScale = one.div(low.blend(
                tiny.blend(-NodeBox.TINY, low.compare(VectorOperators.LT, 0f)),
                low.abs().compare(VectorOperators.LE, NodeBox.TINY)));
        FloatVector highScale = one.div(
                high.blend(tiny.blend(-NodeBox.TINY, falling), high.abs().compare(VectorOperators.LE, NodeBox.TINY)));
        FloatVector nearScale = highScale.blend(lowScale, falling);
        FloatVector farScale = lowScale.blend(highScale, falling).blend(0f, straddling);
        FloatVector secondScale = FloatVector.zero(Lanes.FLOATS).blend(lowScale, straddling);
        FloatVector near = nearScale.mul(origin);
        FloatVector far = farScale.mul(origin);
        FloatVector second = secondScale.mul(origin);
        nearScale.intoArray(facts, NEAR_SCALE + column);
        farScale.intoArray(facts, FAR_SCALE + column);
        secondScale.intoArray(facts, SECOND_SCALE + column);
        near.abs().mul(-ROUNDING).sub(near).intoArray(facts, NEAR_ADDITION + column);
        far.abs().mul(ROUNDING).sub(far).blend(Slab.NEVER, straddling).intoArray(facts, FAR_ADDITION + column);
        second.abs().mul(-ROUNDING).sub(second).intoArray(facts, SECOND_ADDITION + column);
        falls[axis] = falling.toLong();
        straddles |= straddling.toLong();
    }

    /**
     * One bit a box that a lane's beam may meet before its end.
     *
     * @param boxes {@link WideHierarchy#boxes}
     * @param at where the node's are
     */
    long meeting(float[] boxes, int at, int lane) {
        float[] f = facts;
        int x = at + AXES * (int) (falls[0] >>> lane & 1);
        int y = at + AXES * (int) (falls[1] >>> lane & 1) + Lanes.COUNT;
        int z = at + AXES * (int) (falls[2] >>> lane & 1) + 2 * Lanes.COUNT;
        FloatVector near =
                FloatVector.fromArray(Lanes.FLOATS, boxes, x).fma(f[NEAR_SCALE + lane], f[NEAR_ADDITION + lane]);
        FloatVector nearY = FloatVector.fromArray(Lanes.FLOATS, boxes, y)
                .fma(f[NEAR_SCALE + Lanes.COUNT + lane], f[NEAR_ADDITION + Lanes.COUNT + lane]);
        FloatVector nearZ = FloatVector.fromArray(Lanes.FLOATS, boxes, z)
                .fma(f[NEAR_SCALE + 2 * Lanes.COUNT + lane], f[NEAR_ADDITION + 2 * Lanes.COUNT + lane]);
        near = near.blend(nearY, nearY.compare(VectorOperators.GT, near));
        near = near.blend(nearZ, nearZ.compare(VectorOperators.GT, near));
        FloatVector sideX = FloatVector.fromArray(Lanes.FLOATS, boxes, 2 * at + AXES - x);
        FloatVector sideY = FloatVector.fromArray(Lanes.FLOATS, boxes, 2 * (at + Lanes.COUNT) + AXES - y);
        FloatVector sideZ = FloatVector.fromArray(Lanes.FLOATS, boxes, 2 * (at + 2 * Lanes.COUNT) + AXES - z);
        FloatVector far = sideX.fma(f[FAR_SCALE + lane], f[FAR_ADDITION + lane]);
        FloatVector farY = sideY.fma(f[FAR_SCALE + Lanes.COUNT + lane], f[FAR_ADDITION + Lanes.COUNT + lane]);
        FloatVector farZ = sideZ.fma(f[FAR_SCALE + 2 * Lanes.COUNT + lane], f[FAR_ADDITION + 2 * Lanes.COUNT + lane]);
        far = far.blend(farY, farY.compare(VectorOperators.LT, far));
        far = far.blend(farZ, farZ.compare(VectorOperators.LT, far));
        if ((straddles >>> lane & 1) != 0) {
            FloatVector secondX = sideX.fma(f[SECOND_SCALE + lane], f[SECOND_ADDITION + lane]);
            FloatVector secondY =
                    sideY.fma(f[SECOND_SCALE + Lanes.COUNT + lane], f[SECOND_ADDITION + Lanes.COUNT + lane]);
            FloatVector secondZ =
                    sideZ.fma(f[SECOND_SCALE + 2 * Lanes.COUNT + lane], f[SECOND_ADDITION + 2 * Lanes.COUNT + lane]);
            near = near.blend(secondX, secondX.compare(VectorOperators.GT, near));
            near = near.blend(secondY, secondY.compare(VectorOperators.GT, near));
            near = near.blend(secondZ, secondZ.compare(VectorOperators.GT, near));
        }
        return near.compare(VectorOperators.LE, far)
                .and(near.compare(VectorOperators.LE, f[END + lane]))
                .and(far.compare(VectorOperators.GE, 0f))
                .toLong();
    }
}
