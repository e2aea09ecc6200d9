package dev.twister.engine.vector;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Where in the panorama each ray looks: {@link dev.twister.kernel.SkyLookup}'s column and row, with its arc tangent. */
final class SkyDirection {
    private static final float PI = 3.1415927f;
    private static final float HALF_PI = 1.5707964f;
    private static final float TURNS_PER_RADIAN = 0.15915494f;
    private static final float HALF_TURNS_PER_RADIAN = 0.31830987f;

    /** Less than any coordinate that matters, more than 0: keeps 0 / 0 away. */
    private static final float TINY = 1e-37f;

    private SkyDirection() {}

    /** Writes the angles about the vertical, in [-pi, pi], to the column of {@link Tile#SKY_TO_RIGHT}. */
    static void findAzimuths(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            FloatVector x = Lanes.load(t, at + Tile.DIRECTION_X);
            FloatVector z = Lanes.load(t, at + Tile.DIRECTION_Z);
            FloatVector quadrant = quadrant(z.abs(), x.abs());
            FloatVector half = quadrant.blend(Lanes.all(PI).sub(quadrant), x.compare(VectorOperators.LT, 0f));
            half.blend(half.neg(), z.compare(VectorOperators.LT, 0f)).intoArray(t, at + Tile.SKY_TO_RIGHT);
        }
    }

    /** Writes the angles above the horizon, in [-pi / 2, pi / 2], to the column of {@link Tile#SKY_TO_BOTTOM}. */
    static void findElevations(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            FloatVector x = Lanes.load(t, at + Tile.DIRECTION_X);
            FloatVector y = Lanes.load(t, at + Tile.DIRECTION_Y);
            FloatVector z = Lanes.load(t, at + Tile.DIRECTION_Z);
            FloatVector quadrant = quadrant(y.abs(), x.fma(x, z.mul(z)).sqrt());
            quadrant.blend(quadrant.neg(), y.compare(VectorOperators.LT, 0f)).intoArray(t, at + Tile.SKY_TO_BOTTOM);
        }
    }

    /** Turns the angles into the upper left texels and the fractions from them. */
    static void findTexels(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            // The border counts 1 more, and the texels' centres lie half a texel in.
            FloatVector column = Lanes.load(t, at + Tile.SKY_TO_RIGHT)
                    .mul(TURNS_PER_RADIAN)
                    .add(0.5f)
                    .mul(sky.width)
                    .add(0.5f);
            FloatVector row = Lanes.all(0.5f)
                    .sub(Lanes.load(t, at + Tile.SKY_TO_BOTTOM).mul(HALF_TURNS_PER_RADIAN))
                    .mul(sky.height)
                    .add(0.5f);
            IntVector left = Lanes.truncated(column);
            IntVector top = Lanes.truncated(row);
            column.sub(Lanes.toFloats(left)).intoArray(t, at + Tile.SKY_TO_RIGHT);
            row.sub(Lanes.toFloats(top)).intoArray(t, at + Tile.SKY_TO_BOTTOM);
            top.mul(sky.stride()).add(left).intoArray(tile.texels, at);
        }
    }

    /** The angle of (x, y), both at least 0, in radians, in [0, pi / 2]. */
    private static FloatVector quadrant(FloatVector y, FloatVector x) {
        VectorMask<Float> steep = y.compare(VectorOperators.GT, x);
        FloatVector larger = x.blend(y, steep);
        FloatVector smaller = y.blend(x, steep);
        FloatVector ratio = smaller.div(Lanes.larger(larger, Lanes.all(TINY)));
        FloatVector octant = arcTangent(ratio);
        return octant.blend(Lanes.all(HALF_PI).sub(octant), steep);
    }

    /** Of a ratio in [0, 1]: the scalar kernel's polynomial. */
    private static FloatVector arcTangent(FloatVector ratio) {
        FloatVector s = ratio.mul(ratio);
        FloatVector polynomial = Lanes.all(0.0029035176f);
        polynomial = polynomial.fma(s, Lanes.all(-0.01628287f));
        polynomial = polynomial.fma(s, Lanes.all(0.043039143f));
        polynomial = polynomial.fma(s, Lanes.all(-0.07533658f));
        polynomial = polynomial.fma(s, Lanes.all(0.106546685f));
        polynomial = polynomial.fma(s, Lanes.all(-0.14207132f));
        polynomial = polynomial.fma(s, Lanes.all(0.19993053f));
        polynomial = polynomial.fma(s, Lanes.all(-0.33333093f));
        return ratio.fma(polynomial.mul(s), ratio);
    }
}
