package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Surface data of spheres; lanes of a packet that hit something else keep their values. */
public final class SphereSurface {
    private SphereSurface() {}

    /** Writes the spheres hit, the hit points and the normals. */
    public static void find(Drawing drawing, Tile tile) {
        fetch(tile, drawing);
        findOffsets(tile);
        findPoints(tile);
    }

    /** Copies each lane's sphere into the lane; its center goes to the normal's columns. */
    static void fetch(Tile tile, Drawing drawing) {
        if (drawing.bodies.fitLanes()) {
            pick(tile, drawing.bodies);
        } else if (drawing.crowded) {
            copyOfMany(tile, drawing.bodies);
        } else {
            copy(tile, drawing.bodies);
        }
    }

    /** For scenes in which one vector holds a column of all bodies. */
    static void pick(Tile tile, BodyColumns bodies) {
        float[] t = tile.values;
        float[] columns = bodies.surfaceColumns;
        for (int k = 0; k < tile.spheres.count; k++) {
            int at = tile.spheres.places[k];
            FloatVector hit = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT);
            VectorMask<Float> here = hit.compare(VectorOperators.GT, Layout.PLANE);
            for (int column = 0; column < BodyColumns.SURFACE_NUMBERS; column++) {
                int to = at + Tile.SURFACE + column * Tile.SIZE;
                FloatVector picked = hit.selectFrom(
                        FloatVector.fromArray(Lanes.FLOATS, columns, Lanes.BORDER + column * Lanes.COUNT));
                FloatVector.fromArray(Lanes.FLOATS, t, to).blend(picked, here).intoArray(t, to);
            }
        }
    }

    /** Copies lane by lane. */
    static void copy(Tile tile, BodyColumns bodies) {
        float[] t = tile.values;
        float[] surfaces = bodies.surfaces;
        int[] places = bodies.surfacePlaces;
        for (int k = 0; k < tile.spheres.count; k++) {
            int at = tile.spheres.places[k];
            long rest = Lanes.load(t, at + Tile.HIT)
                    .compare(VectorOperators.GT, Layout.PLANE)
                    .toLong();
            while (rest != 0) {
                int pixel = at + Long.numberOfTrailingZeros(rest);
                int from = places[(int) t[pixel + Tile.HIT]];
                for (int number = 0; number < BodyColumns.SURFACE_NUMBERS; number++) {
                    t[pixel + Tile.SURFACE + number * Tile.SIZE] = surfaces[from + number];
                }
                rest &= rest - 1;
            }
        }
    }

    /**
     * As above, where the caches do not hold all spheres: one value of each sphere is read before any is copied, so
     * that the cache misses overlap.
     */
    static void copyOfMany(Tile tile, BodyColumns bodies) {
        float[] t = tile.values;
        float[] surfaces = bodies.surfaces;
        int[] places = bodies.surfacePlaces;
        int[] pixels = tile.lonely.pixels;
        int count = 0;
        for (int k = 0; k < tile.spheres.count; k++) {
            int at = tile.spheres.places[k];
            long here = Lanes.load(t, at + Tile.HIT)
                    .compare(VectorOperators.GT, Layout.PLANE)
                    .toLong();
            Lanes.pack(tile.pixels, at, here, pixels, count);
            count += Long.bitCount(here);
        }
        int[] from = tile.surfacePlaces;
        for (int k = 0; k < count; k++) {
            from[k] = places[(int) t[pixels[k] + Tile.HIT]];
        }
        float sum = 0f;
        for (int k = 0; k < count; k++) {
            sum += surfaces[from[k]];
        }
        tile.readAhead = sum;
        for (int k = 0; k < count; k++) {
            for (int number = 0; number < BodyColumns.SURFACE_NUMBERS; number++) {
                t[pixels[k] + Tile.SURFACE + number * Tile.SIZE] = surfaces[from[k] + number];
            }
        }
    }

    /** Writes the hit points relative to the spheres' centers. */
    static void findOffsets(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.spheres.count; k++) {
            int at = tile.spheres.places[k];
            findOffset(t, at, Tile.DIRECTION_X, Tile.ORIGIN_X, Tile.NORMAL_X, Tile.FROM_CENTER_X);
            findOffset(t, at, Tile.DIRECTION_Y, Tile.ORIGIN_Y, Tile.NORMAL_Y, Tile.FROM_CENTER_Y);
            findOffset(t, at, Tile.DIRECTION_Z, Tile.ORIGIN_Z, Tile.NORMAL_Z, Tile.FROM_CENTER_Z);
        }
    }

    private static void findOffset(float[] t, int at, int direction, int origin, int center, int offset) {
        Lanes.load(t, at + origin)
                .add(Lanes.load(t, at + Tile.DISTANCE).mul(Lanes.load(t, at + direction)))
                .sub(Lanes.load(t, at + center))
                .intoArray(t, at + offset);
    }

    /** Turns the centers into normals, and places the points on the spheres along them. */
    static void findPoints(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.spheres.count; k++) {
            int at = tile.spheres.places[k];
            VectorMask<Float> here = Lanes.load(t, at + Tile.HIT).compare(VectorOperators.GT, Layout.PLANE);
            FloatVector x = Lanes.load(t, at + Tile.FROM_CENTER_X);
            FloatVector y = Lanes.load(t, at + Tile.FROM_CENTER_Y);
            FloatVector z = Lanes.load(t, at + Tile.FROM_CENTER_Z);
            FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            FloatVector radius = Lanes.load(t, at + Tile.RADIUS);
            // A helper would take vectors and a mask, which become objects where it is not inlined.
            for (int axis = at; axis < at + 3 * Tile.SIZE; axis += Tile.SIZE) {
                FloatVector unit = Lanes.load(t, axis + Tile.FROM_CENTER_X).mul(inverse);
                FloatVector center = Lanes.load(t, axis + Tile.NORMAL_X);
                Lanes.load(t, axis + Tile.POINT_X)
                        .blend(center.add(unit.mul(radius)), here)
                        .intoArray(t, axis + Tile.POINT_X);
                center.blend(unit, here).intoArray(t, axis + Tile.NORMAL_X);
            }
        }
    }
}
