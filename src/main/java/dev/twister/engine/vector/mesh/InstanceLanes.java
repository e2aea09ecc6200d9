package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Triangle;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** A packet's rays in the coordinates of an instance's mesh ({@link Instance}), prepared for {@link Triangle}. */
final class InstanceLanes {
    private InstanceLanes() {}

    /** Transforms another traversal's rays by the given rows, and copies their ends. */
    static void transform(Tile tile, PacketWalk from, PacketWalk to, float[] hierarchy, int rows) {
        float[] f = from.rays;
        float[] r = to.rays;
        for (int axis = 0; axis < 3; axis++) {
            int row = rows + 4 * axis;
            FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.ORIGIN)
                    .mul(hierarchy[row])
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.ORIGIN + Lanes.COUNT)
                            .mul(hierarchy[row + 1]))
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.ORIGIN + 2 * Lanes.COUNT)
                            .mul(hierarchy[row + 2]))
                    .add(hierarchy[row + 3])
                    .intoArray(r, PacketWalk.ORIGIN + axis * Lanes.COUNT);
            FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.DIRECTION)
                    .mul(hierarchy[row])
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.DIRECTION + Lanes.COUNT)
                            .mul(hierarchy[row + 1]))
                    .add(FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.DIRECTION + 2 * Lanes.COUNT)
                            .mul(hierarchy[row + 2]))
                    .intoArray(r, PacketWalk.DIRECTION + axis * Lanes.COUNT);
        }
        FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.END).intoArray(r, PacketWalk.END);
        reach(from, to, hierarchy, rows);
    }

    /** Writes {@link Instance#reach} of the origins, the largest of the three coordinates. */
    private static void reach(PacketWalk from, PacketWalk to, float[] hierarchy, int rows) {
        float[] f = from.rays;
        FloatVector x =
                FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.ORIGIN).abs();
        FloatVector y = FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.ORIGIN + Lanes.COUNT)
                .abs();
        FloatVector z = FloatVector.fromArray(Lanes.FLOATS, f, PacketWalk.ORIGIN + 2 * Lanes.COUNT)
                .abs();
        FloatVector largest = FloatVector.broadcast(Lanes.FLOATS, 0f);
        for (int row = rows; row < rows + 12; row += 4) {
            FloatVector sum = x.mul(Math.abs(hierarchy[row]))
                    .add(y.mul(Math.abs(hierarchy[row + 1])))
                    .add(z.mul(Math.abs(hierarchy[row + 2])))
                    .add(Math.abs(hierarchy[row + 3]));
            largest = Lanes.larger(largest, sum);
        }
        largest.intoArray(to.rays, PacketWalk.REACH);
    }

    /** Writes the reach of rays in the world for a small mesh: that of their origins and its own. */
    static void reach(Tile tile, PacketWalk walk, float own) {
        float[] r = walk.rays;
        FloatVector x =
                FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN).abs();
        FloatVector y = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN + Lanes.COUNT)
                .abs();
        FloatVector z = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN + 2 * Lanes.COUNT)
                .abs();
        Lanes.larger(Lanes.larger(x, y), z).add(own).intoArray(r, PacketWalk.REACH);
    }

    /**
     * Writes the dominant axis of each direction, which axes that is for any active ray, and the shear along it.
     * Selects the first active ray for the traversal order.
     */
    static void shear(Tile tile, PacketWalk walk) {
        float[] r = walk.rays;
        FloatVector x = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DIRECTION);
        FloatVector y = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DIRECTION + Lanes.COUNT);
        FloatVector z = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DIRECTION + 2 * Lanes.COUNT);
        VectorMask<Float> alongX = x.abs().compare(VectorOperators.GT, y.abs());
        VectorMask<Float> alongZ = z.abs().compare(VectorOperators.GT, y.abs().blend(x.abs(), alongX));
        FloatVector.broadcast(Lanes.FLOATS, 1f)
                .blend(0f, alongX)
                .blend(2f, alongZ)
                .intoArray(r, PacketWalk.AXIS);
        FloatVector inverse =
                FloatVector.broadcast(Lanes.FLOATS, 1f).div(y.blend(x, alongX).blend(z, alongZ));
        inverse.intoArray(r, PacketWalk.LONGEST_INVERSE);
        z.blend(y, alongX).blend(x, alongZ).mul(inverse).intoArray(r, PacketWalk.SHEAR_FIRST);
        x.blend(z, alongX).blend(y, alongZ).mul(inverse).intoArray(r, PacketWalk.SHEAR_SECOND);
        FloatVector originX = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN);
        FloatVector originY = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN + Lanes.COUNT);
        FloatVector originZ = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN + 2 * Lanes.COUNT);
        originZ.blend(originY, alongX).blend(originX, alongZ).intoArray(r, PacketWalk.FIRST);
        originX.blend(originZ, alongX).blend(originY, alongZ).intoArray(r, PacketWalk.SECOND);
        originY.blend(originX, alongX).blend(originZ, alongZ).intoArray(r, PacketWalk.THIRD);
        long lanes = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.END)
                .compare(VectorOperators.GE, 0f)
                .toLong();
        walk.follow(Long.numberOfTrailingZeros(lanes));
        long onZ = alongZ.toLong();
        long onX = alongX.toLong() & ~onZ;
        walk.axes =
                ((lanes & onX) != 0L ? 1 : 0) | ((lanes & ~onX & ~onZ) != 0L ? 2 : 0) | ((lanes & onZ) != 0L ? 4 : 0);
    }

    /** Makes the rays that have crossed another body's surface meet those of this one in the same place. */
    static void touch(Tile tile, PacketWalk walk, int at, int body) {
        float[] t = tile.values;
        FloatVector inside = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.INSIDE);
        VectorMask<Float> crossed = inside.compare(VectorOperators.LT, 0f)
                .or(inside.compare(VectorOperators.GT, 1f))
                .and(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.LEAVING).compare(VectorOperators.NE, body));
        FloatVector reach = FloatVector.fromArray(Lanes.FLOATS, walk.rays, PacketWalk.REACH);
        reach.blend(reach.neg(), crossed).intoArray(walk.rays, PacketWalk.REACH);
    }

    /**
     * Writes the triangle of the body that each ray leaves, which the ray ignores.
     *
     * @param leaving the tile's column of the bodies that the rays leave
     * @param triangles the tile's column of the triangles that the rays leave
     */
    static void ignore(Tile tile, PacketWalk walk, int at, int leaving, int triangles, int body) {
        float[] t = tile.values;
        VectorMask<Float> own =
                FloatVector.fromArray(Lanes.FLOATS, t, at + leaving).compare(VectorOperators.EQ, body);
        FloatVector.broadcast(Lanes.FLOATS, Layout.NOTHING)
                .blend(FloatVector.fromArray(Lanes.FLOATS, t, at + triangles), own)
                .intoArray(walk.rays, PacketWalk.IGNORED);
    }
}
