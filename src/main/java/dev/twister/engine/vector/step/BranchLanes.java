package dev.twister.engine.vector.step;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.lanes.WaitingRays;
import dev.twister.kernel.Branch;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Secondary rays of surfaces of any material: {@link Branch}. In lanes, all of them wait and fill new packets. */
public final class BranchLanes {
    /** Tile columns with the data of a reflected and of a refracted ray, in the order of {@link WaitingRays}. */
    private static final int[] REFLECTED = from(Tile.DIRECTION_X);

    private static final int[] REFRACTED = from(Tile.REFRACTED_X);

    private BranchLanes() {}

    private static int[] from(int direction) {
        return new int[] {
            direction,
            direction + Tile.SIZE,
            direction + 2 * Tile.SIZE,
            Tile.POINT_X,
            Tile.POINT_Y,
            Tile.POINT_Z,
            Tile.HIT,
            Tile.NEXT_INSIDE,
            Tile.NEXT_RED,
            Tile.NEXT_GREEN,
            Tile.NEXT_BLUE,
            Tile.PIXEL,
            Tile.PLACE_X,
            Tile.PLACE_Y,
            Tile.TRIANGLE
        };
    }

    /** Queues the reflected and refracted rays of all surfaces. */
    public static void split(Tile tile, WaitingRays rays, int bounce) {
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            long reflected = reflect(tile, at);
            if (reflected != 0L) {
                rays.add(tile, at, reflected, bounce + 1, REFLECTED);
            }
        }
        for (int k = 0; k < tile.transparent.count; k++) {
            int at = tile.transparent.places[k];
            long refracted = refract(tile, at);
            if (refracted != 0L) {
                rays.add(tile, at, refracted, bounce + 1, REFRACTED);
            }
        }
    }

    /** Writes the tints of the reflected rays; returns one bit per ray that continues. */
    public static long reflect(Tile tile, int at) {
        float[] t = tile.values;
        FloatVector part = Lanes.load(t, at + Tile.THROUGHPUT);
        FloatVector red = part.mul(Lanes.load(t, at + Tile.TINT_RED)).mul(Lanes.load(t, at + Tile.SHEEN_RED));
        FloatVector green = part.mul(Lanes.load(t, at + Tile.TINT_GREEN)).mul(Lanes.load(t, at + Tile.SHEEN_GREEN));
        FloatVector blue = part.mul(Lanes.load(t, at + Tile.TINT_BLUE)).mul(Lanes.load(t, at + Tile.SHEEN_BLUE));
        red.intoArray(t, at + Tile.NEXT_RED);
        green.intoArray(t, at + Tile.NEXT_GREEN);
        blue.intoArray(t, at + Tile.NEXT_BLUE);
        Lanes.load(t, at + Tile.FROM_INSIDE).intoArray(t, at + Tile.NEXT_INSIDE);
        FloatVector strongest = Lanes.larger(Lanes.larger(red, green), blue);
        VectorMask<Float> transmits = Lanes.load(t, at + Tile.TRANSMISSION).compare(VectorOperators.GT, 0f);
        FloatVector least = Lanes.all(0f).blend(Branch.LEAST_THROUGHPUT, transmits);
        return strongest
                .compare(VectorOperators.GT, 0f)
                .and(strongest.compare(VectorOperators.GE, least))
                .toLong();
    }

    /** As above, for the refracted rays. */
    static long refract(Tile tile, int at) {
        float[] t = tile.values;
        FloatVector part = Lanes.load(t, at + Tile.REFRACTED_PART);
        FloatVector red = part.mul(Lanes.load(t, at + Tile.TINT_RED)).mul(Lanes.load(t, at + Tile.PASSED_RED));
        FloatVector green = part.mul(Lanes.load(t, at + Tile.TINT_GREEN)).mul(Lanes.load(t, at + Tile.PASSED_GREEN));
        FloatVector blue = part.mul(Lanes.load(t, at + Tile.TINT_BLUE)).mul(Lanes.load(t, at + Tile.PASSED_BLUE));
        red.intoArray(t, at + Tile.NEXT_RED);
        green.intoArray(t, at + Tile.NEXT_GREEN);
        blue.intoArray(t, at + Tile.NEXT_BLUE);
        VectorMask<Float> out = Lanes.load(t, at + Tile.FROM_INSIDE)
                .compare(VectorOperators.GT, 0f)
                .or(Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.PLANE));
        Lanes.all(Layout.CROSSED_INTO).blend(Layout.CROSSED_OUT, out).intoArray(t, at + Tile.NEXT_INSIDE);
        return Lanes.larger(Lanes.larger(red, green), blue)
                .compare(VectorOperators.GE, Branch.LEAST_THROUGHPUT)
                .toLong();
    }

    /** Resumes waiting rays of a bounce, with black colors and a throughput of 1. */
    public static void resume(Tile tile, WaitingRays rays, int bounce) {
        int count = rays.take(tile, bounce);
        float[] t = tile.values;
        tile.live.clear();
        for (int at = 0; at < count; at += Lanes.COUNT) {
            tile.live.add(at);
            Lanes.all(0f).intoArray(t, at + Tile.RED);
            Lanes.all(0f).intoArray(t, at + Tile.GREEN);
            Lanes.all(0f).intoArray(t, at + Tile.BLUE);
            VectorMask<Float> there = VectorMask.fromLong(Lanes.FLOATS, Lanes.first(count - at));
            Lanes.all(0f).blend(1f, there).intoArray(t, at + Tile.THROUGHPUT);
        }
        tile.rays = count;
    }

    /** Adds the rays' colors to the pixels that they contribute to. */
    public static void add(Tile rays, Tile pixels) {
        float[] from = rays.values;
        float[] to = pixels.values;
        for (int ray = 0; ray < rays.rays; ray++) {
            int pixel = (int) from[ray + Tile.PIXEL];
            to[pixel + Tile.RED] += from[ray + Tile.RED] * from[ray + Tile.TINT_RED];
            to[pixel + Tile.GREEN] += from[ray + Tile.GREEN] * from[ray + Tile.TINT_GREEN];
            to[pixel + Tile.BLUE] += from[ray + Tile.BLUE] * from[ray + Tile.TINT_BLUE];
        }
    }
}
