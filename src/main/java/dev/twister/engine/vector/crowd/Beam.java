package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.ShadingLight;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * A region that contains a set of rays, or of lines from points to the light's disc. Every line starts inside one box
 * at t = 0 and stays between the two bounds of a {@link Slab} along each axis.
 *
 * <p>The tests call the Vector API directly instead of {@link Lanes}: in large methods C2 does not inline helpers, and
 * their vectors would become objects.
 */
public final class Beam {
    /**
     * Widening of a ray's slopes, so that rounding drops no sphere that brute force finds. A sphere's distance across
     * the ray carries a rounding error of about 10 * 2^-24 of its distance, and t one of 3 * 2^-24 of t.
     */
    static final float SPREAD = 4e-6f;

    /** Widening of the disc, relative to its distance and radius. */
    static final float DISC_SPREAD = 2e-5f;

    /** Size of a sphere's box relative to the sphere. */
    private static final float SPHERE_MARGIN = 1.0001f;

    static final float EVERYWHERE = 1e29f;

    /** t at the ends of the lines. */
    float end;

    private final Slab x = new Slab();
    private final Slab y = new Slab();
    private final Slab z = new Slab();
    private boolean straddles;

    /** Results of the last {@link #bound}. */
    private float low;

    private float high;

    /** Holds one pixel's ray, up to {@link #endAt}. */
    void holdRay(float[] t, int pixel) {
        ray(x, t[pixel + Tile.ORIGIN_X], t[pixel + Tile.DIRECTION_X]);
        ray(y, t[pixel + Tile.ORIGIN_Y], t[pixel + Tile.DIRECTION_Y]);
        ray(z, t[pixel + Tile.ORIGIN_Z], t[pixel + Tile.DIRECTION_Z]);
        finish();
    }

    private static void ray(Slab slab, float origin, float direction) {
        slab.set(origin, origin, direction - SPREAD, direction + SPREAD);
    }

    /** Ends the rays after a distance in meters. */
    public void endAt(float meters) {
        end = Math.min(meters * (1f + SPREAD), EVERYWHERE);
    }

    /**
     * Holds the coherent rays ({@link Tile#TOGETHER}) of several packets.
     *
     * @param first first index in {@link Tile#together}
     * @param end index after the last one
     */
    public void holdRays(Tile tile, int first, int end) {
        rays(x, tile, first, end, Tile.ORIGIN_X, Tile.DIRECTION_X);
        rays(y, tile, first, end, Tile.ORIGIN_Y, Tile.DIRECTION_Y);
        rays(z, tile, first, end, Tile.ORIGIN_Z, Tile.DIRECTION_Z);
        finish();
    }

    private void rays(Slab slab, Tile tile, int first, int end, int origin, int direction) {
        bound(tile, tile.together.places, first, end, origin, Tile.TOGETHER);
        float originLow = low;
        float originHigh = high;
        bound(tile, tile.together.places, first, end, direction, Tile.TOGETHER);
        slab.set(originLow, originHigh, low - SPREAD, high + SPREAD);
    }

    /** Holds the lines from one pixel's surface point to the light's disc, up to its outermost sample. */
    public void holdLines(float[] t, int pixel) {
        float distance = t[pixel + Tile.LIGHT_DISTANCE];
        float radius = distance * t[pixel + Tile.DISC_TANGENT];
        float spread = DISC_SPREAD * (distance + radius);
        lines(x, t, pixel + Tile.POINT_X, t[pixel + Tile.TO_LIGHT_X], distance, radius, spread);
        lines(y, t, pixel + Tile.POINT_Y, t[pixel + Tile.TO_LIGHT_Y], distance, radius, spread);
        lines(z, t, pixel + Tile.POINT_Z, t[pixel + Tile.TO_LIGHT_Z], distance, radius, spread);
        end = 1f + DISC_SPREAD;
        finish();
    }

    private static void lines(Slab slab, float[] t, int point, float axis, float distance, float radius, float spread) {
        float reach = radius * (float) Math.sqrt(Math.max(0f, 1f - axis * axis)) + spread;
        slab.set(t[point], t[point], axis * distance - reach, axis * distance + reach);
    }

    /**
     * Holds the lines from a packet's open points to a ball around the light that contains the disc in any orientation.
     *
     * @param number the packet's index in {@link Tile#shadows}
     */
    public void holdLines(Tile tile, Drawing drawing, int number, float radius) {
        ShadingLight light = drawing.lights[tile.light];
        bound(tile, tile.shadows.places, number, number + 1, Tile.POINT_X, Tile.SHADOW_OPEN);
        linesOfAll(x, light.x, radius);
        bound(tile, tile.shadows.places, number, number + 1, Tile.POINT_Y, Tile.SHADOW_OPEN);
        linesOfAll(y, light.y, radius);
        bound(tile, tile.shadows.places, number, number + 1, Tile.POINT_Z, Tile.SHADOW_OPEN);
        linesOfAll(z, light.z, radius);
        end = 1f + DISC_SPREAD;
        finish();
    }

    private void linesOfAll(Slab slab, float light, float radius) {
        float reach = radius + DISC_SPREAD * (radius + Math.abs(light - low) + Math.abs(light - high));
        slab.set(low, high, light - reach - low, light + reach - high);
    }

    /**
     * Finds the minimum and maximum of a column over some packets. It compares ints in the floats' order, because float
     * min and max handle NaN and -0 at every step.
     *
     * @param packets the packets' places
     * @param first first index in {@code packets}
     * @param end index after the last one
     * @param lanes the column that is greater than 0 in the lanes to include
     */
    void bound(Tile tile, int[] packets, int first, int end, int column, int lanes) {
        float[] t = tile.values;
        IntVector leasts = IntVector.broadcast(Lanes.INTS, Integer.MAX_VALUE);
        IntVector greatests = IntVector.broadcast(Lanes.INTS, Integer.MIN_VALUE);
        for (int k = first; k < end; k++) {
            IntVector bits =
                    FloatVector.fromArray(Lanes.FLOATS, t, packets[k] + column).reinterpretAsInts();
            IntVector ordered = bits.lanewise(
                    VectorOperators.XOR, bits.lanewise(VectorOperators.ASHR, 31).lanewise(VectorOperators.LSHR, 1));
            VectorMask<Integer> counts = FloatVector.fromArray(Lanes.FLOATS, t, packets[k] + lanes)
                    .reinterpretAsInts()
                    .compare(VectorOperators.GT, 0);
            leasts = leasts.blend(leasts.min(ordered), counts);
            greatests = greatests.blend(greatests.max(ordered), counts);
        }
        int least = leasts.reduceLanes(VectorOperators.MIN);
        int greatest = greatests.reduceLanes(VectorOperators.MAX);
        low = Float.intBitsToFloat(least ^ least >> 31 >>> 1);
        high = Float.intBitsToFloat(greatest ^ greatest >> 31 >>> 1);
    }

    private void finish() {
        straddles = x.secondScale != 0f || y.secondScale != 0f || z.secondScale != 0f;
    }

    /**
     * Tests the child boxes of one node; returns one bit per box that the beam may meet before its end. Positive floats
     * compare like their bits as ints, and the order of negative entries does not matter, so maxima are taken as ints.
     *
     * @param boxes {@code WideHierarchy.boxes}
     * @param at start of the node's boxes
     * @param entries receives, from {@link Lanes#BORDER} on, the smallest t at which each box may be met, at least 0
     */
    public long meeting(float[] boxes, int at, float[] entries) {
        int sides = 3 * Lanes.COUNT;
        IntVector near = FloatVector.fromArray(Lanes.FLOATS, boxes, at + x.nearSide * sides)
                .sub(x.nearOrigin)
                .mul(x.nearScale)
                .reinterpretAsInts();
        IntVector nearY = FloatVector.fromArray(Lanes.FLOATS, boxes, at + y.nearSide * sides + Lanes.COUNT)
                .sub(y.nearOrigin)
                .mul(y.nearScale)
                .reinterpretAsInts();
        IntVector nearZ = FloatVector.fromArray(Lanes.FLOATS, boxes, at + z.nearSide * sides + 2 * Lanes.COUNT)
                .sub(z.nearOrigin)
                .mul(z.nearScale)
                .reinterpretAsInts();
        FloatVector fromX = FloatVector.fromArray(Lanes.FLOATS, boxes, at + x.farSide * sides)
                .sub(x.farOrigin);
        FloatVector fromY = FloatVector.fromArray(Lanes.FLOATS, boxes, at + y.farSide * sides + Lanes.COUNT)
                .sub(y.farOrigin);
        FloatVector fromZ = FloatVector.fromArray(Lanes.FLOATS, boxes, at + z.farSide * sides + 2 * Lanes.COUNT)
                .sub(z.farOrigin);
        near = near.max(0).max(nearY.max(nearZ));
        if (straddles) {
            near = near.max(fromX.mul(x.secondScale).reinterpretAsInts())
                    .max(fromY.mul(y.secondScale).reinterpretAsInts())
                    .max(fromZ.mul(z.secondScale).reinterpretAsInts());
        }
        IntVector far = fromX.mul(x.farScale).add(x.farAddition).reinterpretAsInts();
        IntVector farY = fromY.mul(y.farScale).add(y.farAddition).reinterpretAsInts();
        IntVector farZ = fromZ.mul(z.farScale).add(z.farAddition).reinterpretAsInts();
        far = far.min(Float.floatToRawIntBits(end)).min(farY.min(farZ));
        near.reinterpretAsFloats().intoArray(entries, Lanes.BORDER);
        return near.compare(VectorOperators.LE, far).toLong();
    }

    /** Tests the spheres of one block; returns one bit per sphere whose box the beam may meet before its end. */
    public long meeting(SphereColumns spheres, int first) {
        float[] values = spheres.values;
        int stride = spheres.stride;
        FloatVector radius = FloatVector.fromArray(Lanes.FLOATS, values, first + SphereColumns.RADIUS * stride)
                .mul(SPHERE_MARGIN);
        FloatVector fromX = FloatVector.fromArray(Lanes.FLOATS, values, first);
        FloatVector fromY = FloatVector.fromArray(Lanes.FLOATS, values, first + SphereColumns.Y * stride);
        FloatVector fromZ = FloatVector.fromArray(Lanes.FLOATS, values, first + SphereColumns.Z * stride);
        IntVector near = fromX.sub(x.nearOrigin)
                .add(radius.mul(2 * x.nearSide - 1))
                .mul(x.nearScale)
                .reinterpretAsInts();
        IntVector nearY = fromY.sub(y.nearOrigin)
                .add(radius.mul(2 * y.nearSide - 1))
                .mul(y.nearScale)
                .reinterpretAsInts();
        IntVector nearZ = fromZ.sub(z.nearOrigin)
                .add(radius.mul(2 * z.nearSide - 1))
                .mul(z.nearScale)
                .reinterpretAsInts();
        fromX = fromX.sub(x.farOrigin).add(radius.mul(2 * x.farSide - 1));
        fromY = fromY.sub(y.farOrigin).add(radius.mul(2 * y.farSide - 1));
        fromZ = fromZ.sub(z.farOrigin).add(radius.mul(2 * z.farSide - 1));
        near = near.max(0).max(nearY.max(nearZ));
        if (straddles) {
            near = near.max(fromX.mul(x.secondScale).reinterpretAsInts())
                    .max(fromY.mul(y.secondScale).reinterpretAsInts())
                    .max(fromZ.mul(z.secondScale).reinterpretAsInts());
        }
        IntVector far = fromX.mul(x.farScale).add(x.farAddition).reinterpretAsInts();
        IntVector farY = fromY.mul(y.farScale).add(y.farAddition).reinterpretAsInts();
        IntVector farZ = fromZ.mul(z.farScale).add(z.farAddition).reinterpretAsInts();
        far = far.min(Float.floatToRawIntBits(end)).min(farY.min(farZ));
        return near.compare(VectorOperators.LE, far).toLong();
    }
}
