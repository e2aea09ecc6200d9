package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.ShadingLight;
import dev.twister.engine.vector.lanes.BodyList;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Shadow;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Spheres that may lie between a packet's points and the light's disc: the culling of {@link Shadow}. */
public final class ShadowCandidates {
    /** Rounding of a disc's slope where it is nearly level. */
    private static final float LEVEL_MARGIN = 1e-3f;

    private ShadowCandidates() {}

    /** Writes the disc's half angles, up to its outermost sample, for all packets with open lanes. */
    public static void findDiscs(Tile tile, Drawing drawing) {
        float[] t = tile.values;
        float radius = drawing.lights[tile.light].discRadius * drawing.rim;
        for (int k = 0; k < tile.shadows.count; k++) {
            int at = tile.shadows.places[k];
            FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
            FloatVector tangent = Lanes.all(radius).div(distance).blend(0f, distance.compare(VectorOperators.LE, 0f));
            tangent.intoArray(t, at + Tile.DISC_TANGENT);
            Lanes.fma(tangent, tangent, Lanes.all(1f)).sqrt().intoArray(t, at + Tile.DISC_SECANT);
        }
    }

    /**
     * Lists one packet's candidates among those of its tile. Sets the visible part of fully shaded lanes to 0, and
     * keeps only the lanes open whose samples must be counted.
     *
     * @param at the packet's place
     * @return whether any lane is still open
     */
    public static boolean find(Tile tile, int at, BodyColumns bodies, ShadowColumns scratch) {
        BodyList candidates = scratch.tileCandidates;
        float[] t = tile.values;
        scratch.startPacket();
        for (int c = 0; c < candidates.count; c++) {
            int body = candidates.bodies[c];
            long between = between(t, at, bodies, body);
            if (between != 0) {
                between &= isOutside(tile, at, bodies, body);
            }
            if (between != 0) {
                scratch.add(body, between, hidesDisc(tile, at, bodies, body));
            }
        }
        return finish(tile, at, scratch) != 0;
    }

    /** As above, among the spheres near the packet's lines, at most {@link ShadowColumns#MOST_TOGETHER}. */
    static boolean findAmong(SphereColumns near, int count, Tile tile, int at, Drawing drawing, ShadowMemory bench) {
        ShadowColumns scratch = bench.columns;
        scratch.startPacket();
        betweens(tile, at, near, count, bench.columns.betweens);
        int bodies = SphereColumns.FIRST + SphereColumns.BODY * near.stride;
        for (int sphere = 0; sphere < count; sphere++) {
            long between = scratch.betweens[sphere];
            if (between != 0) {
                judge(drawing, tile, bench, at, (int) near.values[bodies + sphere], between);
            }
        }
        return finish(tile, at, bench.columns) != 0;
    }

    private static void judge(Drawing drawing, Tile tile, ShadowMemory bench, int at, int body, long between) {
        long shaded = between & isOutside(tile, at, drawing.bodies, body);
        if (shaded != 0) {
            bench.columns.add(body, shaded, hidesDisc(tile, at, drawing.bodies, body));
        }
    }

    /** {@link #between} for each of some spheres. */
    static void betweens(Tile tile, int at, SphereColumns near, int count, long[] betweens) {
        float[] t = tile.values;
        float[] spheres = near.values;
        int stride = near.stride;
        FloatVector pointX = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.POINT_X);
        FloatVector pointY = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.POINT_Y);
        FloatVector pointZ = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.POINT_Z);
        FloatVector toLightX = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_X);
        FloatVector toLightY = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Y);
        FloatVector toLightZ = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Z);
        FloatVector distance = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.LIGHT_DISTANCE);
        FloatVector tangent = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISC_TANGENT);
        FloatVector secant = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISC_SECANT);
        FloatVector farthest = distance.mul(Shadow.RELATIVE_MARGIN);
        for (int k = 0; k < count; k++) {
            int sphere = SphereColumns.FIRST + k;
            float radius = spheres[sphere + SphereColumns.RADIUS * stride];
            FloatVector x = FloatVector.broadcast(Lanes.FLOATS, spheres[sphere]).sub(pointX);
            FloatVector y = FloatVector.broadcast(Lanes.FLOATS, spheres[sphere + SphereColumns.Y * stride])
                    .sub(pointY);
            FloatVector z = FloatVector.broadcast(Lanes.FLOATS, spheres[sphere + SphereColumns.Z * stride])
                    .sub(pointZ);
            FloatVector along = Lanes.fma(x, toLightX, Lanes.fma(y, toLightY, z.mul(toLightZ)));
            FloatVector acrossX = x.sub(along.mul(toLightX));
            FloatVector acrossY = y.sub(along.mul(toLightY));
            FloatVector acrossZ = z.sub(along.mul(toLightZ));
            FloatVector across = Lanes.fma(acrossX, acrossX, Lanes.fma(acrossY, acrossY, acrossZ.mul(acrossZ)));
            FloatVector margin = along.abs().add(distance).add(radius).mul(Shadow.ABSOLUTE_MARGIN);
            FloatVector reach = Lanes.fma(
                    Lanes.fma(along, tangent, secant.mul(radius)),
                    FloatVector.broadcast(Lanes.FLOATS, Shadow.RELATIVE_MARGIN),
                    margin);
            betweens[k] = reach.compare(VectorOperators.GT, 0f)
                    .and(across.compare(VectorOperators.LE, reach.mul(reach)))
                    .and(along.compare(VectorOperators.GT, -radius))
                    .and(along.sub(radius).compare(VectorOperators.LT, farthest))
                    .toLong();
        }
    }

    /** Sets the visible part of fully shaded lanes to 0; returns one bit per lane that is still open. */
    public static long finish(Tile tile, int at, ShadowColumns scratch) {
        float[] t = tile.values;
        long undecided = scratch.touched & ~scratch.dark;
        close(t, at, scratch.dark, undecided);
        return undecided;
    }

    private static void close(float[] t, int at, long dark, long undecided) {
        Lanes.load(t, at + Tile.VISIBLE)
                .blend(0f, VectorMask.fromLong(Lanes.FLOATS, dark))
                .intoArray(t, at + Tile.VISIBLE);
        Lanes.all(0f).blend(1f, VectorMask.fromLong(Lanes.FLOATS, undecided)).intoArray(t, at + Tile.SHADOW_OPEN);
    }

    /** One bit per open lane. */
    public static long open(Tile tile, int at) {
        float[] t = tile.values;
        return Lanes.load(t, at + Tile.SHADOW_OPEN)
                .compare(VectorOperators.GT, 0f)
                .toLong();
    }

    /** One bit per open lane whose point lies on the ground. */
    static long openOnGround(Tile tile, int at) {
        float[] t = tile.values;
        return Lanes.load(t, at + Tile.HIT)
                .compare(VectorOperators.EQ, Layout.PLANE)
                .and(Lanes.load(t, at + Tile.SHADOW_OPEN).compare(VectorOperators.GT, 0f))
                .toLong();
    }

    /** Keeps only the given lanes open. */
    static void narrow(Tile tile, int at, long lanes) {
        float[] t = tile.values;
        Lanes.all(0f).blend(1f, VectorMask.fromLong(Lanes.FLOATS, lanes)).intoArray(t, at + Tile.SHADOW_OPEN);
    }

    /** One bit per lane where the sphere may meet the cone from the point to the disc. */
    public static long between(float[] t, int at, BodyColumns bodies, int body) {
        float[] spheres = bodies.surfaces;
        int sphere = bodies.surfacePlaces[body];
        float radius = spheres[sphere + BodyColumns.RADIUS];
        FloatVector x = Lanes.all(spheres[sphere]).sub(Lanes.load(t, at + Tile.POINT_X));
        FloatVector y = Lanes.all(spheres[sphere + BodyColumns.Y]).sub(Lanes.load(t, at + Tile.POINT_Y));
        FloatVector z = Lanes.all(spheres[sphere + BodyColumns.Z]).sub(Lanes.load(t, at + Tile.POINT_Z));
        FloatVector along = Lanes.fma(
                x,
                Lanes.load(t, at + Tile.TO_LIGHT_X),
                Lanes.fma(y, Lanes.load(t, at + Tile.TO_LIGHT_Y), z.mul(Lanes.load(t, at + Tile.TO_LIGHT_Z))));
        FloatVector acrossX = x.sub(along.mul(Lanes.load(t, at + Tile.TO_LIGHT_X)));
        FloatVector acrossY = y.sub(along.mul(Lanes.load(t, at + Tile.TO_LIGHT_Y)));
        FloatVector acrossZ = z.sub(along.mul(Lanes.load(t, at + Tile.TO_LIGHT_Z)));
        FloatVector across = Lanes.fma(acrossX, acrossX, Lanes.fma(acrossY, acrossY, acrossZ.mul(acrossZ)));
        FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
        FloatVector margin = along.abs().add(distance).add(radius).mul(Shadow.ABSOLUTE_MARGIN);
        FloatVector reach = Lanes.fma(
                Lanes.fma(
                        along,
                        Lanes.load(t, at + Tile.DISC_TANGENT),
                        Lanes.load(t, at + Tile.DISC_SECANT).mul(radius)),
                Lanes.all(Shadow.RELATIVE_MARGIN),
                margin);
        return reach.compare(VectorOperators.GT, 0f)
                .and(across.compare(VectorOperators.LE, reach.mul(reach)))
                .and(along.compare(VectorOperators.GT, -radius))
                .and(along.sub(radius).compare(VectorOperators.LT, distance.mul(Shadow.RELATIVE_MARGIN)))
                .toLong();
    }

    /** One bit per lane whose point may be shaded by what lanes decline: some spheres, and the plane. */
    public static long declined(Tile tile, int at, Drawing drawing) {
        BodyList occluders = drawing.declined.occluders();
        long declined = drawing.lights[tile.light].planeMayShade ? acrossPlane(tile, at, drawing) : 0L;
        for (int k = 0; k < occluders.count; k++) {
            declined |= between(tile.values, at, drawing.bodies, occluders.bodies[k]);
        }
        return declined;
    }

    /**
     * One bit per lane whose point is on a sphere or mesh and has the plane between it and part of the light's disc.
     */
    private static long acrossPlane(Tile tile, int at, Drawing drawing) {
        ShadingLight light = drawing.lights[tile.light];
        FloatVector y = Lanes.load(tile.values, at + Tile.POINT_Y);
        FloatVector rise = Lanes.load(tile.values, at + Tile.TO_LIGHT_Y);
        FloatVector level =
                Lanes.larger(Lanes.all(0f), Lanes.all(1f).sub(rise.mul(rise))).sqrt();
        float margin = LEVEL_MARGIN * light.discRadius
                + Shadow.ABSOLUTE_MARGIN * (Math.abs(light.y) + Math.abs(drawing.planeHeight));
        FloatVector reach = Lanes.fma(level, Lanes.all(light.discRadius * Shadow.RELATIVE_MARGIN), Lanes.all(margin));
        VectorMask<Float> fromBelow = y.compare(VectorOperators.LE, drawing.planeHeight)
                .and(reach.add(light.y).compare(VectorOperators.GE, drawing.planeHeight));
        VectorMask<Float> fromAbove = y.compare(VectorOperators.GE, drawing.planeHeight)
                .and(Lanes.all(light.y).sub(reach).compare(VectorOperators.LE, drawing.planeHeight));
        return fromBelow.or(fromAbove).toLong()
                & Lanes.load(tile.values, at + Tile.HIT)
                        .compare(VectorOperators.GT, Layout.PLANE)
                        .toLong();
    }

    /** One bit per open lane whose point is neither on the sphere nor inside it. */
    static long isOutside(Tile tile, int at, BodyColumns bodies, int body) {
        float[] t = tile.values;
        float[] spheres = bodies.surfaces;
        int sphere = bodies.surfacePlaces[body];
        float radius = spheres[sphere + BodyColumns.RADIUS];
        FloatVector x = Lanes.all(spheres[sphere]).sub(Lanes.load(t, at + Tile.POINT_X));
        FloatVector y = Lanes.all(spheres[sphere + BodyColumns.Y]).sub(Lanes.load(t, at + Tile.POINT_Y));
        FloatVector z = Lanes.all(spheres[sphere + BodyColumns.Z]).sub(Lanes.load(t, at + Tile.POINT_Z));
        return Lanes.fma(x, x, Lanes.fma(y, y, z.mul(z)))
                .compare(VectorOperators.GT, radius * radius)
                .and(Lanes.load(t, at + Tile.SHADOW_OPEN).compare(VectorOperators.GT, 0f))
                .and(Lanes.load(t, at + Tile.HIT).compare(VectorOperators.NE, body))
                .toLong();
    }

    /**
     * One bit per lane where the sphere certainly blocks the whole disc: it lies entirely between, and its cone seen
     * from the point contains the disc's cone.
     */
    static long hidesDisc(Tile tile, int at, BodyColumns bodies, int body) {
        float[] t = tile.values;
        float[] spheres = bodies.surfaces;
        int sphere = bodies.surfacePlaces[body];
        float radius = spheres[sphere + BodyColumns.RADIUS];
        FloatVector x = Lanes.all(spheres[sphere]).sub(Lanes.load(t, at + Tile.POINT_X));
        FloatVector y = Lanes.all(spheres[sphere + BodyColumns.Y]).sub(Lanes.load(t, at + Tile.POINT_Y));
        FloatVector z = Lanes.all(spheres[sphere + BodyColumns.Z]).sub(Lanes.load(t, at + Tile.POINT_Z));
        FloatVector along = Lanes.fma(
                x,
                Lanes.load(t, at + Tile.TO_LIGHT_X),
                Lanes.fma(y, Lanes.load(t, at + Tile.TO_LIGHT_Y), z.mul(Lanes.load(t, at + Tile.TO_LIGHT_Z))));
        FloatVector acrossX = x.sub(along.mul(Lanes.load(t, at + Tile.TO_LIGHT_X)));
        FloatVector acrossY = y.sub(along.mul(Lanes.load(t, at + Tile.TO_LIGHT_Y)));
        FloatVector acrossZ = z.sub(along.mul(Lanes.load(t, at + Tile.TO_LIGHT_Z)));
        FloatVector perpendicular = Lanes.fma(acrossX, acrossX, Lanes.fma(acrossY, acrossY, acrossZ.mul(acrossZ)))
                .sqrt();
        FloatVector tangent = Lanes.load(t, at + Tile.DISC_TANGENT);
        FloatVector secant = Lanes.load(t, at + Tile.DISC_SECANT);
        FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
        return along.compare(VectorOperators.GT, radius)
                .and(along.add(radius).compare(VectorOperators.LT, distance.mul(Shadow.UMBRA_MARGIN)))
                .and(along.compare(VectorOperators.GT, perpendicular.mul(tangent)))
                .and(Lanes.fma(along, tangent, perpendicular)
                        .compare(VectorOperators.LE, secant.mul(radius * Shadow.UMBRA_MARGIN)))
                .toLong();
    }
}
