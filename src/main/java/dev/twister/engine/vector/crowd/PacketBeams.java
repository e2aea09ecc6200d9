package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.NodeBox;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * One {@link Beam} per lane, around a pixel's ray or its point's lines to the light's disc. All are set up at once;
 * {@link PacketLeaves} then tests each beam against as many boxes as there are lanes.
 */
public final class PacketBeams {
    /** Margin for a plane's t, relative to the origin's part of it, which carries a rounding error of 3 * 2^-24. */
    private static final float ROUNDING = 2e-7f;

    // Three columns each, one per axis: scale and addition for the t of the near side, far side and second near side.
    static final int AXES = 3 * Lanes.COUNT;
    static final int NEAR_SCALE = 0;
    static final int NEAR_ADDITION = AXES;
    static final int FAR_SCALE = 2 * AXES;
    static final int FAR_ADDITION = 3 * AXES;
    static final int SECOND_SCALE = 4 * AXES;
    static final int SECOND_ADDITION = 5 * AXES;

    /** t at the ends of the lines. */
    static final int END = 6 * AXES;

    /** Slope bounds: meters along the axis per unit of t. */
    private static final int LOW = END + Lanes.COUNT;

    private static final int HIGH = LOW + AXES;

    /** Origin, direction and length of the lines. */
    public static final int ORIGIN = HIGH + AXES;

    public static final int DIRECTION = ORIGIN + AXES;
    public static final int LENGTH = DIRECTION + AXES;

    /** For lines to the light: tangent and secant of the cone's half angle, and the body at their start. */
    public static final int TANGENT = LENGTH + Lanes.COUNT;

    public static final int SECANT = TANGENT + Lanes.COUNT;
    public static final int OWN = SECANT + Lanes.COUNT;

    /** Bits per axis in {@link #nearSides}. */
    static final int SIDE_BITS = 8;

    static final int SIDE = (1 << SIDE_BITS) - 1;

    public final float[] facts = new float[OWN + Lanes.COUNT];

    /**
     * Per lane, the offset of the near sides from the low sides in {@code WideHierarchy.boxes}: the high sides' offset
     * or 0. x is in the lowest bits, then y and z. Negative where the slopes differ in sign along any axis.
     */
    final int[] nearSides = new int[Lanes.COUNT];

    /**
     * Holds the rays of some pixels, up to their closest hits so far.
     *
     * @param pixels pixel numbers, one per lane; lanes beyond the number of rays may hold any valid pixel
     * @param first index of the first pixel number
     */
    void holdRays(float[] t, int[] pixels, int first) {
        // A scalar loop: some JVMs allocate an object for a gathered vector.
        for (int lane = 0; lane < Lanes.COUNT; lane++) {
            int pixel = pixels[first + lane];
            facts[ORIGIN + lane] = t[Tile.ORIGIN_X + pixel];
            facts[ORIGIN + Lanes.COUNT + lane] = t[Tile.ORIGIN_Y + pixel];
            facts[ORIGIN + 2 * Lanes.COUNT + lane] = t[Tile.ORIGIN_Z + pixel];
            facts[DIRECTION + lane] = t[Tile.DIRECTION_X + pixel];
            facts[DIRECTION + Lanes.COUNT + lane] = t[Tile.DIRECTION_Y + pixel];
            facts[DIRECTION + 2 * Lanes.COUNT + lane] = t[Tile.DIRECTION_Z + pixel];
            facts[LENGTH + lane] = t[Tile.DISTANCE + pixel];
        }
        for (int axis = 0; axis < 3; axis++) {
            FloatVector direction = FloatVector.fromArray(Lanes.FLOATS, facts, DIRECTION + axis * Lanes.COUNT);
            direction.sub(Beam.SPREAD).intoArray(facts, LOW + axis * Lanes.COUNT);
            direction.add(Beam.SPREAD).intoArray(facts, HIGH + axis * Lanes.COUNT);
        }
        FloatVector.fromArray(Lanes.FLOATS, facts, LENGTH)
                .mul(1f + Beam.SPREAD)
                .min(Beam.EVERYWHERE)
                .intoArray(facts, END);
        finish();
    }

    /** Holds the lines from some pixels' points to the light's disc, up to its outermost sample. Pixels as above. */
    public void holdLines(float[] t, int[] pixels, int first) {
        for (int lane = 0; lane < Lanes.COUNT; lane++) {
            int pixel = pixels[first + lane];
            facts[ORIGIN + lane] = t[Tile.POINT_X + pixel];
            facts[ORIGIN + Lanes.COUNT + lane] = t[Tile.POINT_Y + pixel];
            facts[ORIGIN + 2 * Lanes.COUNT + lane] = t[Tile.POINT_Z + pixel];
            facts[DIRECTION + lane] = t[Tile.TO_LIGHT_X + pixel];
            facts[DIRECTION + Lanes.COUNT + lane] = t[Tile.TO_LIGHT_Y + pixel];
            facts[DIRECTION + 2 * Lanes.COUNT + lane] = t[Tile.TO_LIGHT_Z + pixel];
            facts[LENGTH + lane] = t[Tile.LIGHT_DISTANCE + pixel];
            facts[TANGENT + lane] = t[Tile.DISC_TANGENT + pixel];
            facts[SECANT + lane] = t[Tile.DISC_SECANT + pixel];
            facts[OWN + lane] = t[Tile.HIT + pixel];
        }
        FloatVector distance = FloatVector.fromArray(Lanes.FLOATS, facts, LENGTH);
        FloatVector radius = FloatVector.fromArray(Lanes.FLOATS, facts, TANGENT).mul(distance);
        FloatVector spread = distance.add(radius).mul(Beam.DISC_SPREAD);
        for (int axis = 0; axis < 3; axis++) {
            FloatVector along = FloatVector.fromArray(Lanes.FLOATS, facts, DIRECTION + axis * Lanes.COUNT);
            FloatVector reach =
                    along.mul(along).neg().add(1f).max(0f).sqrt().mul(radius).add(spread);
            FloatVector middle = along.mul(distance);
            middle.sub(reach).intoArray(facts, LOW + axis * Lanes.COUNT);
            middle.add(reach).intoArray(facts, HIGH + axis * Lanes.COUNT);
        }
        FloatVector.broadcast(Lanes.FLOATS, 1f + Beam.DISC_SPREAD).intoArray(facts, END);
        finish();
    }

    private void finish() {
        IntVector.zero(Lanes.INTS).intoArray(nearSides, 0);
        for (int axis = 0; axis < 3; axis++) {
            findPlanes(axis);
        }
    }

    /** See {@link Slab#set}. */
    private void findPlanes(int axis) {
        int column = axis * Lanes.COUNT;
        FloatVector origin = FloatVector.fromArray(Lanes.FLOATS, facts, ORIGIN + column);
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
        IntVector.fromArray(Lanes.INTS, nearSides, 0)
                .or(IntVector.zero(Lanes.INTS)
                        .blend(AXES << (SIDE_BITS * axis), falling.cast(Lanes.INTS))
                        .blend(Integer.MIN_VALUE, straddling.cast(Lanes.INTS)))
                .intoArray(nearSides, 0);
    }
}
