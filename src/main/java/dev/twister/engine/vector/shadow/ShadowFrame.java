package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Shortcut;
import dev.twister.engine.vector.lanes.BodyList;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shortcut.ShadowConics;
import dev.twister.kernel.Shadow;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Candidates relative to a packet's points, in the frame of {@link Shadow}. */
public final class ShadowFrame {
    private ShadowFrame() {}

    /** Writes each lane's disc axes. */
    public static void findAxes(Tile tile, int at, Drawing drawing, ShadowColumns scratch) {
        float[] t = tile.values;
        float[] frame = scratch.frame;
        FloatVector x = Lanes.load(t, at + Tile.TO_LIGHT_X);
        FloatVector y = Lanes.load(t, at + Tile.TO_LIGHT_Y);
        FloatVector z = Lanes.load(t, at + Tile.TO_LIGHT_Z);
        FloatVector acrossSquared = Lanes.fma(y, y, z.mul(z));
        VectorMask<Float> alongX = acrossSquared.compare(VectorOperators.LE, 0f);
        FloatVector scale = Lanes.inverseRoot(acrossSquared.blend(x.mul(x), alongX));
        FloatVector uY = z.mul(scale).blend(0f, alongX);
        FloatVector uZ = y.neg().blend(x, alongX).mul(scale);
        uY.intoArray(frame, ShadowColumns.U_Y);
        uZ.intoArray(frame, ShadowColumns.U_Z);
        uY.mul(z).sub(uZ.mul(y)).intoArray(frame, ShadowColumns.W_X);
        uZ.mul(x).intoArray(frame, ShadowColumns.W_Y);
        uY.mul(x).neg().intoArray(frame, ShadowColumns.W_Z);
        FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
        Lanes.all(drawing.lights[tile.light].discRadius)
                .div(distance)
                .blend(0f, distance.compare(VectorOperators.LE, 0f))
                .intoArray(frame, ShadowColumns.SCALE);
    }

    /** Writes the candidates' centers in the frame. */
    static void placeAll(Tile tile, int at, BodyColumns bodies, ShadowColumns scratch) {
        BodyList found = scratch.candidates;
        scratch.reserveFacts(found.count);
        for (int c = 0; c < found.count; c++) {
            place(tile, at, bodies, found.bodies[c], scratch, c * ShadowColumns.STRIDE);
        }
    }

    /** Writes the squared radii, negative in lanes that the sphere cannot shade. */
    static void limitAll(Tile tile, int at, BodyColumns bodies, ShadowColumns scratch) {
        BodyList found = scratch.candidates;
        for (int c = 0; c < found.count; c++) {
            int body = found.bodies[c];
            limit(tile.values, at, body, bodies.sphereRadius(body), scratch.facts, c * ShadowColumns.STRIDE);
        }
    }

    /** Writes whether the conics are valid for all candidates and lanes. */
    static void judgeAll(Tile tile, int at, Drawing drawing, ShadowColumns scratch) {
        BodyColumns bodies = drawing.bodies;
        BodyList found = scratch.candidates;
        long rays = 0;
        for (int c = 0; c < found.count; c++) {
            rays |= needsRays(tile.values, at, bodies.sphereRadius(found.bodies[c]), scratch, c * ShadowColumns.STRIDE);
        }
        scratch.conical = rays == 0 && drawing.shortcuts.take(Shortcut.CONICS);
    }

    private static void place(Tile tile, int at, BodyColumns bodies, int body, ShadowColumns scratch, int to) {
        float[] t = tile.values;
        float[] frame = scratch.frame;
        float[] spheres = bodies.surfaces;
        int sphere = bodies.surfacePlaces[body];
        FloatVector x = Lanes.all(spheres[sphere]).sub(Lanes.load(t, at + Tile.POINT_X));
        FloatVector y = Lanes.all(spheres[sphere + BodyColumns.Y]).sub(Lanes.load(t, at + Tile.POINT_Y));
        FloatVector z = Lanes.all(spheres[sphere + BodyColumns.Z]).sub(Lanes.load(t, at + Tile.POINT_Z));
        FloatVector along = Lanes.fma(
                x,
                Lanes.load(t, at + Tile.TO_LIGHT_X),
                Lanes.fma(y, Lanes.load(t, at + Tile.TO_LIGHT_Y), z.mul(Lanes.load(t, at + Tile.TO_LIGHT_Z))));
        FloatVector u = Lanes.fma(y, Lanes.load(frame, ShadowColumns.U_Y), z.mul(Lanes.load(frame, ShadowColumns.U_Z)));
        FloatVector w = Lanes.fma(
                x,
                Lanes.load(frame, ShadowColumns.W_X),
                Lanes.fma(y, Lanes.load(frame, ShadowColumns.W_Y), z.mul(Lanes.load(frame, ShadowColumns.W_Z))));
        along.intoArray(scratch.facts, to + ShadowColumns.ALONG);
        u.intoArray(scratch.facts, to + ShadowColumns.ACROSS_U);
        w.intoArray(scratch.facts, to + ShadowColumns.ACROSS_W);
    }

    private static void limit(float[] t, int at, int body, float radius, float[] facts, int to) {
        FloatVector along = Lanes.load(facts, to + ShadowColumns.ALONG);
        FloatVector u = Lanes.load(facts, to + ShadowColumns.ACROSS_U);
        FloatVector w = Lanes.load(facts, to + ShadowColumns.ACROSS_W);
        FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
        float radiusSquared = radius * radius;
        VectorMask<Float> shades = along.compare(VectorOperators.GT, -radius)
                .and(along.sub(radius).compare(VectorOperators.LT, distance.mul(Shadow.RELATIVE_MARGIN)))
                .and(Lanes.fma(along, along, Lanes.fma(u, u, w.mul(w))).compare(VectorOperators.GT, radiusSquared))
                .and(Lanes.load(t, at + Tile.HIT).compare(VectorOperators.NE, body))
                .and(Lanes.load(t, at + Tile.SHADOW_OPEN).compare(VectorOperators.GT, 0f));
        Lanes.all(-1f).blend(radiusSquared, shades).intoArray(facts, to + ShadowColumns.RADIUS_SQUARED);
    }

    /**
     * One bit per lane that the sphere may shade, but whose conic is invalid: because the sphere does not lie entirely
     * between the point and the disc, or is too small. It lies between if its center is in front of the plane through
     * the point perpendicular to every line to the disc that meets the sphere, and if the sphere ends before the disc.
     */
    private static long needsRays(float[] t, int at, float radius, ShadowColumns scratch, int to) {
        FloatVector along = Lanes.load(scratch.facts, to + ShadowColumns.ALONG);
        FloatVector u = Lanes.load(scratch.facts, to + ShadowColumns.ACROSS_U);
        FloatVector w = Lanes.load(scratch.facts, to + ShadowColumns.ACROSS_W);
        FloatVector widest = Lanes.fma(u, u, w.mul(w)).sqrt().mul(Lanes.load(scratch.frame, ShadowColumns.SCALE));
        FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
        return along.mul(ShadowConics.WITHIN)
                .compare(VectorOperators.LE, widest)
                .or(along.add(radius).compare(VectorOperators.GE, distance.mul(ShadowConics.WITHIN)))
                .or(along.mul(Lanes.load(t, at + Tile.DISC_TANGENT))
                        .compare(VectorOperators.GT, radius * ShadowConics.MOST_RADII_WIDE))
                .and(Lanes.load(scratch.facts, to + ShadowColumns.RADIUS_SQUARED)
                        .compare(VectorOperators.GE, 0f))
                .toLong();
    }
}
