package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.PaddedSky;
import dev.twister.engine.vector.lanes.ArcTangent;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.KernelMath;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Position of each ray in the panorama: column and row of {@link dev.twister.kernel.SkyLookup}, with its arc tangent.
 */
public final class SkyDirection {
    private static final float TURNS_PER_RADIAN = 0.15915494f;
    private static final float HALF_TURNS_PER_RADIAN = 0.31830987f;

    /** Smaller than any relevant coordinate and positive: avoids 0 / 0. */
    private static final float TINY = 1e-37f;

    private SkyDirection() {}

    /** Writes column and row in the padded sky for the packets that hit the sky. */
    public static void find(PaddedSky sky, Tile tile) {
        findRatios(tile);
        findArcTangents(tile, Tile.SKY_TO_RIGHT);
        findArcTangents(tile, Tile.SKY_TO_BOTTOM);
        findColumns(tile, sky);
        findRows(tile, sky);
    }

    /**
     * Writes the ratios for the arc tangents: min / max of |x| and |z|, for the azimuth, to {@link Tile#SKY_TO_RIGHT},
     * and min / max of |y| and the length of (x, z), for the elevation, to {@link Tile#SKY_TO_BOTTOM}. Both share one
     * division, the slowest operation.
     */
    static void findRatios(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            FloatVector x = Lanes.load(t, at + Tile.DIRECTION_X).abs();
            FloatVector y = Lanes.load(t, at + Tile.DIRECTION_Y).abs();
            FloatVector z = Lanes.load(t, at + Tile.DIRECTION_Z).abs();
            FloatVector level = Lanes.fma(x, x, z.mul(z)).sqrt();
            VectorMask<Float> sideways = z.compare(VectorOperators.GT, x);
            VectorMask<Float> steep = y.compare(VectorOperators.GT, level);
            FloatVector larger = Lanes.larger(x.blend(z, sideways), Lanes.all(TINY));
            FloatVector higher = level.blend(y, steep);
            FloatVector inverse = Lanes.all(1f).div(larger.mul(higher));
            z.blend(x, sideways).mul(higher).mul(inverse).intoArray(t, at + Tile.SKY_TO_RIGHT);
            y.blend(level, steep).mul(larger).mul(inverse).intoArray(t, at + Tile.SKY_TO_BOTTOM);
        }
    }

    /** Replaces a column's ratios in [0, 1] by their arc tangents, by the scalar kernel's polynomial. */
    static void findArcTangents(Tile tile, int column) {
        float[] t = tile.values;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k] + column;
            ArcTangent.of(Lanes.load(t, at)).intoArray(t, at);
        }
    }

    /**
     * Turns the arc tangents into azimuths in [-pi, pi] and then into columns of the padded sky, in texels, with
     * integers at texel centers.
     */
    static void findColumns(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            FloatVector x = Lanes.load(t, at + Tile.DIRECTION_X);
            FloatVector z = Lanes.load(t, at + Tile.DIRECTION_Z);
            FloatVector octant = Lanes.load(t, at + Tile.SKY_TO_RIGHT);
            FloatVector quadrant = octant.blend(
                    Lanes.all(KernelMath.HALF_PI).sub(octant), x.abs().compare(VectorOperators.GT, z.abs()));
            FloatVector half =
                    quadrant.blend(Lanes.all(KernelMath.PI).sub(quadrant), z.compare(VectorOperators.LT, 0f));
            FloatVector turns = half.blend(half.neg(), x.compare(VectorOperators.LT, 0f))
                    .mul(TURNS_PER_RADIAN)
                    .add(0.5f)
                    .sub(sky.turn);
            // The border adds 1, and a texel's center is half a texel in.
            turns.blend(turns.add(1f), turns.compare(VectorOperators.LT, 0f))
                    .mul(sky.width)
                    .add(0.5f)
                    .intoArray(t, at + Tile.SKY_TO_RIGHT);
        }
    }

    /** Turns the arc tangents into elevations in [-pi / 2, pi / 2] and then into rows. */
    static void findRows(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            FloatVector x = Lanes.load(t, at + Tile.DIRECTION_X);
            FloatVector y = Lanes.load(t, at + Tile.DIRECTION_Y);
            FloatVector z = Lanes.load(t, at + Tile.DIRECTION_Z);
            FloatVector octant = Lanes.load(t, at + Tile.SKY_TO_BOTTOM);
            VectorMask<Float> steep = y.mul(y).compare(VectorOperators.GT, Lanes.fma(x, x, z.mul(z)));
            FloatVector quadrant = octant.blend(Lanes.all(KernelMath.HALF_PI).sub(octant), steep);
            FloatVector elevation = quadrant.blend(quadrant.neg(), y.compare(VectorOperators.LT, 0f));
            Lanes.all(0.5f)
                    .sub(elevation.mul(HALF_TURNS_PER_RADIAN))
                    .mul(sky.height)
                    .add(0.5f)
                    .intoArray(t, at + Tile.SKY_TO_BOTTOM);
        }
    }
}
