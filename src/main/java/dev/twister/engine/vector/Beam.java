package dev.twister.engine.vector;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/**
 * A region that holds some rays, or lines from points to the light's disc: every line starts in one box at t = 0, and along
 * each axis lies between the two bounds of a {@link Slab}.
 *
 * <p>The tests call the Vector API itself and no helper of {@link Lanes}: a helper is no longer inlined once the method
 * around it has become large, and its vectors would become objects.
 */
final class Beam {
    /**
     * How far a ray's slopes are spread, so that rounding drops no sphere that a look at all of them would find: the
     * distance of a sphere across a ray is rounded by some ten units of 2^-24 of its distance, and t by three of its own.
     */
    static final float SPREAD = 4e-6f;

    /** How far the disc is spread, as a part of its distance and of its radius. */
    static final float DISC_SPREAD = 2e-5f;

    /** What a sphere's box is larger than the sphere. */
    private static final float SPHERE_MARGIN = 1.0001f;

    static final float EVERYWHERE = 1e29f;

    /** The t at which the lines end. */
    float end;

    private final Slab x = new Slab();
    private final Slab y = new Slab();
    private final Slab z = new Slab();
    private boolean straddles;

    /** The ray of that pixel, as far as {@link #endAt} says. */
    void holdRay(float[] t, int pixel) {
        ray(x, t[pixel + Tile.ORIGIN_X], t[pixel + Tile.DIRECTION_X]);
        ray(y, t[pixel + Tile.ORIGIN_Y], t[pixel + Tile.DIRECTION_Y]);
        ray(z, t[pixel + Tile.ORIGIN_Z], t[pixel + Tile.DIRECTION_Z]);
        finish();
    }

    private static void ray(Slab slab, float origin, float direction) {
        slab.set(origin, origin, direction - SPREAD, direction + SPREAD);
    }

    /** Ends the rays after so many metres. */
    void endAt(float metres) {
        end = Math.min(metres * (1f + SPREAD), EVERYWHERE);
    }

    /** The rays of the packet that keep {@link Tile#TOGETHER}. */
    void holdRays(float[] t, int at) {
        rays(x, t, at, Tile.ORIGIN_X, Tile.DIRECTION_X);
        rays(y, t, at, Tile.ORIGIN_Y, Tile.DIRECTION_Y);
        rays(z, t, at, Tile.ORIGIN_Z, Tile.DIRECTION_Z);
        finish();
    }

    private static void rays(Slab slab, float[] t, int at, int origin, int direction) {
        slab.set(
                least(t, at + origin, at + Tile.TOGETHER),
                most(t, at + origin, at + Tile.TOGETHER),
                least(t, at + direction, at + Tile.TOGETHER) - SPREAD,
                most(t, at + direction, at + Tile.TOGETHER) + SPREAD);
    }

    /** The lines from the point of that pixel to the light's disc, as far as its outermost sample. */
    void holdLines(float[] t, int pixel) {
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

    /** The lines from the packet's open points to a ball about the light, which holds the disc whatever way it faces. */
    void holdLines(float[] t, int at, BodyColumns bodies, int light, float radius) {
        linesOfAll(x, t, at, Tile.POINT_X, bodies.x[light], radius);
        linesOfAll(y, t, at, Tile.POINT_Y, bodies.y[light], radius);
        linesOfAll(z, t, at, Tile.POINT_Z, bodies.z[light], radius);
        end = 1f + DISC_SPREAD;
        finish();
    }

    private static void linesOfAll(Slab slab, float[] t, int at, int point, float light, float radius) {
        float low = least(t, at + point, at + Tile.SHADOW_OPEN);
        float high = most(t, at + point, at + Tile.SHADOW_OPEN);
        float reach = radius + DISC_SPREAD * (radius + Math.abs(light - low) + Math.abs(light - high));
        slab.set(low, high, light - reach - low, light + reach - high);
    }

    private static float least(float[] t, int at, int lanes) {
        return FloatVector.fromArray(Lanes.FLOATS, t, at)
                .reduceLanes(
                        VectorOperators.MIN,
                        FloatVector.fromArray(Lanes.FLOATS, t, lanes).compare(VectorOperators.GT, 0f));
    }

    private static float most(float[] t, int at, int lanes) {
        return FloatVector.fromArray(Lanes.FLOATS, t, at)
                .reduceLanes(
                        VectorOperators.MAX,
                        FloatVector.fromArray(Lanes.FLOATS, t, lanes).compare(VectorOperators.GT, 0f));
    }

    private void finish() {
        straddles = x.secondScale != 0f || y.secondScale != 0f || z.secondScale != 0f;
    }

    /**
     * One bit a box that the beam may meet before its end.
     *
     * @param boxes {@link WideHierarchy#boxes}
     * @param at where the node's are
     * @param entries gets the t from which on each box may be met; less than 0 where that is from the start
     */
    long meeting(float[] boxes, int at, float[] entries) {
        int sides = 3 * Lanes.COUNT;
        FloatVector near = FloatVector.fromArray(Lanes.FLOATS, boxes, at + x.nearSide * sides)
                .sub(x.nearOrigin)
                .mul(x.nearScale);
        FloatVector nearY = FloatVector.fromArray(Lanes.FLOATS, boxes, at + y.nearSide * sides + Lanes.COUNT)
                .sub(y.nearOrigin)
                .mul(y.nearScale);
        FloatVector nearZ = FloatVector.fromArray(Lanes.FLOATS, boxes, at + z.nearSide * sides + 2 * Lanes.COUNT)
                .sub(z.nearOrigin)
                .mul(z.nearScale);
        FloatVector fromX = FloatVector.fromArray(Lanes.FLOATS, boxes, at + x.farSide * sides)
                .sub(x.farOrigin);
        FloatVector fromY = FloatVector.fromArray(Lanes.FLOATS, boxes, at + y.farSide * sides + Lanes.COUNT)
                .sub(y.farOrigin);
        FloatVector fromZ = FloatVector.fromArray(Lanes.FLOATS, boxes, at + z.farSide * sides + 2 * Lanes.COUNT)
                .sub(z.farOrigin);
        near = near.blend(nearY, nearY.compare(VectorOperators.GT, near));
        near = near.blend(nearZ, nearZ.compare(VectorOperators.GT, near));
        FloatVector far = fromX.fma(x.farScale, x.farAddition);
        FloatVector farY = fromY.fma(y.farScale, y.farAddition);
        FloatVector farZ = fromZ.fma(z.farScale, z.farAddition);
        far = far.blend(farY, farY.compare(VectorOperators.LT, far));
        far = far.blend(farZ, farZ.compare(VectorOperators.LT, far));
        if (straddles) {
            FloatVector secondX = fromX.mul(x.secondScale);
            FloatVector secondY = fromY.mul(y.secondScale);
            FloatVector secondZ = fromZ.mul(z.secondScale);
            near = near.blend(secondX, secondX.compare(VectorOperators.GT, near));
            near = near.blend(secondY, secondY.compare(VectorOperators.GT, near));
            near = near.blend(secondZ, secondZ.compare(VectorOperators.GT, near));
        }
        near.intoArray(entries, 0);
        return near.compare(VectorOperators.LE, far)
                .and(near.compare(VectorOperators.LE, end))
                .and(far.compare(VectorOperators.GE, 0f))
                .toLong();
    }

    /** One bit a sphere of the packet at that place whose box the beam may meet before its end. */
    long meeting(SphereColumns spheres, int first) {
        float[] values = spheres.values;
        int stride = spheres.stride;
        FloatVector radius = FloatVector.fromArray(Lanes.FLOATS, values, first + SphereColumns.RADIUS * stride)
                .mul(SPHERE_MARGIN);
        FloatVector fromX = FloatVector.fromArray(Lanes.FLOATS, values, first);
        FloatVector fromY = FloatVector.fromArray(Lanes.FLOATS, values, first + SphereColumns.Y * stride);
        FloatVector fromZ = FloatVector.fromArray(Lanes.FLOATS, values, first + SphereColumns.Z * stride);
        FloatVector near =
                fromX.sub(x.nearOrigin).add(radius.mul(2 * x.nearSide - 1)).mul(x.nearScale);
        FloatVector nearY =
                fromY.sub(y.nearOrigin).add(radius.mul(2 * y.nearSide - 1)).mul(y.nearScale);
        FloatVector nearZ =
                fromZ.sub(z.nearOrigin).add(radius.mul(2 * z.nearSide - 1)).mul(z.nearScale);
        fromX = fromX.sub(x.farOrigin).add(radius.mul(2 * x.farSide - 1));
        fromY = fromY.sub(y.farOrigin).add(radius.mul(2 * y.farSide - 1));
        fromZ = fromZ.sub(z.farOrigin).add(radius.mul(2 * z.farSide - 1));
        near = near.blend(nearY, nearY.compare(VectorOperators.GT, near));
        near = near.blend(nearZ, nearZ.compare(VectorOperators.GT, near));
        FloatVector far = fromX.fma(x.farScale, x.farAddition);
        FloatVector farY = fromY.fma(y.farScale, y.farAddition);
        FloatVector farZ = fromZ.fma(z.farScale, z.farAddition);
        far = far.blend(farY, farY.compare(VectorOperators.LT, far));
        far = far.blend(farZ, farZ.compare(VectorOperators.LT, far));
        if (straddles) {
            FloatVector secondX = fromX.mul(x.secondScale);
            FloatVector secondY = fromY.mul(y.secondScale);
            FloatVector secondZ = fromZ.mul(z.secondScale);
            near = near.blend(secondX, secondX.compare(VectorOperators.GT, near));
            near = near.blend(secondY, secondY.compare(VectorOperators.GT, near));
            near = near.blend(secondZ, secondZ.compare(VectorOperators.GT, near));
        }
        return near.compare(VectorOperators.LE, far)
                .and(near.compare(VectorOperators.LE, end))
                .and(far.compare(VectorOperators.GE, 0f))
                .toLong();
    }
}
