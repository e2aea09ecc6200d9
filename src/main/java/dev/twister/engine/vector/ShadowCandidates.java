package dev.twister.engine.vector;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Which spheres may come between a packet's points and the light's disc: {@link dev.twister.kernel.SoftShadow}'s culling. */
final class ShadowCandidates {
    private static final float RELATIVE_MARGIN = 1.0005f;
    private static final float ABSOLUTE_MARGIN = 1e-5f;
    private static final float UMBRA_MARGIN = 0.999f;

    private ShadowCandidates() {}

    /**
     * Lists them in {@code found}. Makes the lanes wholly in the dark invisible, and leaves open only those whose samples
     * must be counted.
     *
     * @param at the packet's place
     * @return whether any lane is still open
     */
    static boolean find(Tile tile, int at, Drawing drawing, BodyList candidates, BodyList found) {
        float[] t = tile.values;
        found.clear();
        FloatVector slope = slope(t, at, drawing);
        FloatVector slant = slope.fma(slope, Lanes.all(1f)).sqrt();
        VectorMask<Float> open = Lanes.load(t, at + Tile.SHADOW_OPEN).compare(VectorOperators.GT, 0f);
        VectorMask<Float> touched = open.andNot(open);
        VectorMask<Float> dark = touched;
        for (int c = 0; c < candidates.count; c++) {
            int body = candidates.bodies[c];
            BodyColumns bodies = drawing.bodies;
            FloatVector along = along(t, at, bodies, body);
            FloatVector across = acrossSquared(t, at, bodies, body, along);
            float radius = bodies.radius[body];
            VectorMask<Float> between = between(t, at, along, across, radius, slope, slant)
                    .and(open)
                    .and(Lanes.load(t, at + Tile.HIT).compare(VectorOperators.NE, body));
            if (between.anyTrue()) {
                found.add(body);
                touched = touched.or(between);
                dark = dark.or(
                        hidesDisc(t, at, along, across, radius, slope, slant).and(between));
            }
        }
        VectorMask<Float> undecided = touched.andNot(dark);
        if (dark.anyTrue()) {
            Lanes.load(t, at + Tile.VISIBLE).blend(0f, dark).intoArray(t, at + Tile.VISIBLE);
        }
        Lanes.all(0f).blend(1f, undecided).intoArray(t, at + Tile.SHADOW_OPEN);
        return undecided.anyTrue();
    }

    /** The tangent of the disc's half angle, as far as its outermost sample. */
    private static FloatVector slope(float[] t, int at, Drawing drawing) {
        FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
        FloatVector slope = Lanes.all(drawing.discRadius * drawing.rim).div(distance);
        return slope.blend(0f, distance.compare(VectorOperators.LE, 0f));
    }

    private static FloatVector along(float[] t, int at, BodyColumns bodies, int body) {
        FloatVector x = Lanes.all(bodies.x[body]).sub(Lanes.load(t, at + Tile.POINT_X));
        FloatVector y = Lanes.all(bodies.y[body]).sub(Lanes.load(t, at + Tile.POINT_Y));
        FloatVector z = Lanes.all(bodies.z[body]).sub(Lanes.load(t, at + Tile.POINT_Z));
        return x.fma(
                Lanes.load(t, at + Tile.TO_LIGHT_X),
                y.fma(Lanes.load(t, at + Tile.TO_LIGHT_Y), z.mul(Lanes.load(t, at + Tile.TO_LIGHT_Z))));
    }

    private static FloatVector acrossSquared(float[] t, int at, BodyColumns bodies, int body, FloatVector along) {
        FloatVector x = across(t, at, bodies.x[body], along, Tile.POINT_X, Tile.TO_LIGHT_X);
        FloatVector y = across(t, at, bodies.y[body], along, Tile.POINT_Y, Tile.TO_LIGHT_Y);
        FloatVector z = across(t, at, bodies.z[body], along, Tile.POINT_Z, Tile.TO_LIGHT_Z);
        return x.fma(x, y.fma(y, z.mul(z)));
    }

    private static FloatVector across(float[] t, int at, float center, FloatVector along, int point, int toLight) {
        return Lanes.all(center).sub(Lanes.load(t, at + point)).sub(along.mul(Lanes.load(t, at + toLight)));
    }

    /** Where the sphere may meet the cone from the point to the disc, and the point is not inside it. */
    private static VectorMask<Float> between(
            float[] t,
            int at,
            FloatVector along,
            FloatVector across,
            float radius,
            FloatVector slope,
            FloatVector slant) {
        FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
        FloatVector margin = along.abs().add(distance).add(radius).mul(ABSOLUTE_MARGIN);
        FloatVector reach =
                along.fma(slope, slant.mul(radius)).mul(RELATIVE_MARGIN).add(margin);
        return along.compare(VectorOperators.GT, -radius)
                .and(along.sub(radius).compare(VectorOperators.LT, distance.mul(RELATIVE_MARGIN)))
                .and(reach.compare(VectorOperators.GT, 0f))
                .and(across.compare(VectorOperators.LE, reach.mul(reach)))
                .and(along.fma(along, across).compare(VectorOperators.GT, radius * radius));
    }

    /** Where the sphere surely hides the whole disc: it lies wholly between, and its cone holds the disc's. */
    private static VectorMask<Float> hidesDisc(
            float[] t,
            int at,
            FloatVector along,
            FloatVector across,
            float radius,
            FloatVector slope,
            FloatVector slant) {
        FloatVector perpendicular = across.sqrt();
        FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
        FloatVector sloping = along.mul(slope);
        return along.compare(VectorOperators.GT, radius)
                .and(along.add(radius).compare(VectorOperators.LT, distance.mul(UMBRA_MARGIN)))
                .and(along.compare(VectorOperators.GT, perpendicular.mul(slope)))
                .and(perpendicular.add(sloping).compare(VectorOperators.LE, slant.mul(radius * UMBRA_MARGIN)));
    }
}
