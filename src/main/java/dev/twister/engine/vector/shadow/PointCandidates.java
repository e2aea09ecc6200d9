package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shortcut.ShadowConics;
import dev.twister.kernel.KernelMath;
import dev.twister.kernel.Shadow;
import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * The possible occluders between one point and the light's disc, in the frame of {@link Shadow}. It grows and never
 * shrinks.
 */
public final class PointCandidates {
    /** Columns: center along A, U and W, and squared radius. */
    private static final int A = 0;

    private static final int U = 1;
    private static final int W = 2;
    private static final int RADIUS_SQUARED = 3;

    /** Coefficients of the {@link ShadowConics} conic over the unit disc. */
    private static final int XX = 4;

    private static final int XY = 5;
    private static final int YY = 6;
    private static final int X = 7;
    private static final int Y = 8;
    private static final int CONSTANT = 9;

    /**
     * 1 where the conic is valid: the sphere lies entirely between the point and the disc and is not too small; else 0.
     */
    private static final int CONICAL = 10;

    private static final int COLUMNS = 11;

    private final float[][] facts = new float[COLUMNS][8 * Lanes.COUNT];
    private int count;

    /** Distance to the disc in meters. */
    private float distance;

    /** Factor from the unit disc to the plane at distance 1. */
    private float scale;

    /** A, U, W and squared radius of the spheres judged last, {@link Lanes#COUNT} floats each. */
    private final float[] judged = new float[4 * Lanes.COUNT];

    private float slope;
    private float slant;
    private float own;
    private float pointX;
    private float pointY;
    private float pointZ;
    private float axisX;
    private float axisY;
    private float axisZ;
    private float uY;
    private float uZ;
    private float wX;
    private float wY;
    private float wZ;

    /** Clears the candidates and sets up a point. Its axes are computed as in the kernel. */
    void start(float[] t, int pixel, float discRadius) {
        count = 0;
        distance = t[pixel + Tile.LIGHT_DISTANCE];
        scale = distance > 0f ? discRadius / distance : 0f;
        slope = t[pixel + Tile.DISC_TANGENT];
        slant = t[pixel + Tile.DISC_SECANT];
        own = t[pixel + Tile.HIT];
        pointX = t[pixel + Tile.POINT_X];
        pointY = t[pixel + Tile.POINT_Y];
        pointZ = t[pixel + Tile.POINT_Z];
        axisX = t[pixel + Tile.TO_LIGHT_X];
        axisY = t[pixel + Tile.TO_LIGHT_Y];
        axisZ = t[pixel + Tile.TO_LIGHT_Z];
        float acrossSquared = axisY * axisY + axisZ * axisZ;
        float length = KernelMath.inverseRoot(acrossSquared > 0f ? acrossSquared : axisX * axisX);
        uY = acrossSquared > 0f ? axisZ * length : 0f;
        uZ = acrossSquared > 0f ? -axisY * length : axisX * length;
        wX = uY * axisZ - uZ * axisY;
        wY = uZ * axisX;
        wZ = -uY * axisX;
    }

    /**
     * Adds the candidates among some spheres; returns whether one of them blocks the whole disc.
     *
     * @param first place of the first sphere in the columns
     * @param number number of spheres
     */
    boolean add(SphereColumns spheres, int first, int number) {
        boolean dark = false;
        int at = first;
        for (int left = number; left > 0 && !dark; left -= Lanes.COUNT) {
            dark = judge(spheres.values, spheres.stride, at, Lanes.first(left));
            at += spheres.step;
        }
        return dark;
    }

    /** As above, for the spheres of a leaf. */
    boolean add(WideHierarchy hierarchy, int leaf) {
        return add(hierarchy.spheres, WideHierarchy.firstBlock(leaf), WideHierarchy.blocks(leaf) * Lanes.COUNT);
    }

    /** Allocates room for two more vectors of candidates. */
    private void reserve() {
        if (facts[A].length < count + 2 * Lanes.COUNT) {
            for (int column = 0; column < COLUMNS; column++) {
                facts[column] = Arrays.copyOf(facts[column], 2 * facts[column].length);
            }
        }
    }

    /**
     * {@link Shadow#judge} with one sphere per lane: adds the candidates; returns whether one blocks the whole disc.
     */
    private boolean judge(float[] spheres, int stride, int at, long wanted) {
        FloatVector x = FloatVector.fromArray(Lanes.FLOATS, spheres, at).sub(pointX);
        FloatVector y = FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.Y * stride)
                .sub(pointY);
        FloatVector z = FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.Z * stride)
                .sub(pointZ);
        FloatVector radius = FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.RADIUS * stride);
        FloatVector a = x.mul(axisX).add(y.mul(axisY)).add(z.mul(axisZ));
        FloatVector u = y.mul(uY).add(z.mul(uZ));
        FloatVector w = x.mul(wX).add(y.mul(wY)).add(z.mul(wZ));
        FloatVector radiusSquared = radius.mul(radius);
        FloatVector across = u.mul(u).add(w.mul(w));
        FloatVector reach = a.mul(slope)
                .add(radius.mul(slant))
                .mul(Shadow.RELATIVE_MARGIN)
                .add(a.abs().add(radius).add(distance).mul(Shadow.ABSOLUTE_MARGIN));
        VectorMask<Float> between = a.add(radius)
                .compare(VectorOperators.GT, 0f)
                .and(a.sub(radius).compare(VectorOperators.LT, distance * Shadow.RELATIVE_MARGIN))
                .and(reach.compare(VectorOperators.GT, 0f))
                .and(across.compare(VectorOperators.LE, reach.mul(reach)))
                .and(a.mul(a).add(across).compare(VectorOperators.GT, radiusSquared))
                .and(FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.BODY * stride)
                        .compare(VectorOperators.NE, own));
        long found = between.toLong() & wanted;
        boolean dark = false;
        if (found != 0L) {
            FloatVector perpendicular = across.sqrt();
            VectorMask<Float> hides = a.sub(radius)
                    .compare(VectorOperators.GT, 0f)
                    .and(a.add(radius).compare(VectorOperators.LT, distance * Shadow.UMBRA_MARGIN))
                    .and(a.compare(VectorOperators.GT, perpendicular.mul(slope)))
                    .and(perpendicular
                            .add(a.mul(slope))
                            .compare(VectorOperators.LE, radius.mul(slant).mul(Shadow.UMBRA_MARGIN)));
            dark = (hides.toLong() & found) != 0L;
            reserve();
            if (Lanes.PACK) {
                VectorMask<Float> kept = VectorMask.fromLong(Lanes.FLOATS, found);
                a.compress(kept).intoArray(facts[A], count);
                u.compress(kept).intoArray(facts[U], count);
                w.compress(kept).intoArray(facts[W], count);
                radiusSquared.compress(kept).intoArray(facts[RADIUS_SQUARED], count);
            } else {
                a.intoArray(judged, A * Lanes.COUNT);
                u.intoArray(judged, U * Lanes.COUNT);
                w.intoArray(judged, W * Lanes.COUNT);
                radiusSquared.intoArray(judged, RADIUS_SQUARED * Lanes.COUNT);
                for (int column = A; column <= RADIUS_SQUARED; column++) {
                    Lanes.pack(judged, column * Lanes.COUNT, found, facts[column], count);
                }
            }
            count += Long.bitCount(found);
        }
        return dark;
    }

    /** Writes the candidates' conics and whether they are valid. */
    private void findConics(boolean decide) {
        float nearDisc = distance * ShadowConics.WITHIN;
        float radiiWide = slope / ShadowConics.MOST_RADII_WIDE;
        for (int at = 0; at < count; at += Lanes.COUNT) {
            FloatVector a = FloatVector.fromArray(Lanes.FLOATS, facts[A], at);
            FloatVector u = FloatVector.fromArray(Lanes.FLOATS, facts[U], at);
            FloatVector w = FloatVector.fromArray(Lanes.FLOATS, facts[W], at);
            FloatVector radiusSquared = FloatVector.fromArray(Lanes.FLOATS, facts[RADIUS_SQUARED], at);
            FloatVector across = u.mul(u).add(w.mul(w));
            FloatVector scaledA = a.mul(scale);
            FloatVector scaledU = u.mul(scale);
            FloatVector scaledW = w.mul(scale);
            FloatVector rest = scaledA.mul(scaledA).sub(radiusSquared.mul(scale * scale));
            scaledW.mul(scaledW).add(rest).intoArray(facts[XX], at);
            scaledU.mul(scaledW).mul(-2f).intoArray(facts[XY], at);
            scaledU.mul(scaledU).add(rest).intoArray(facts[YY], at);
            scaledA.mul(u).mul(-2f).intoArray(facts[X], at);
            scaledA.mul(w).mul(-2f).intoArray(facts[Y], at);
            across.sub(radiusSquared).intoArray(facts[CONSTANT], at);
            FloatVector toDisc = a.neg().add(nearDisc);
            VectorMask<Float> conical = a.compare(VectorOperators.GT, 0f)
                    .and(a.mul(a).mul(ShadowConics.WITHIN).compare(VectorOperators.GT, across.mul(scale * scale)))
                    .and(toDisc.compare(VectorOperators.GT, 0f))
                    .and(toDisc.mul(toDisc).compare(VectorOperators.GT, radiusSquared))
                    .and(a.mul(a).mul(radiiWide * radiiWide).compare(VectorOperators.LE, radiusSquared));
            FloatVector.zero(Lanes.FLOATS).blend(decide ? 1f : 0f, conical).intoArray(facts[CONICAL], at);
        }
    }

    /** The visible part of the disc, by conics where they are valid, otherwise ray by ray. */
    float visible(float[] discX, float[] discY, int samples, boolean conics) {
        findConics(conics);
        int blocked = 0;
        for (int sample = 0; sample < samples && count > 0; sample += Lanes.COUNT) {
            long wanted = Lanes.first(samples - sample);
            blocked += Long.bitCount(blocked(discX, discY, sample, wanted));
        }
        return 1f - (float) blocked / samples;
    }

    /** One bit per wanted sample that any candidate blocks. */
    private long blocked(float[] discX, float[] discY, int sample, long wanted) {
        FloatVector x = FloatVector.fromArray(Lanes.FLOATS, discX, sample);
        FloatVector y = FloatVector.fromArray(Lanes.FLOATS, discY, sample);
        float[] xx = facts[XX];
        float[] xy = facts[XY];
        float[] yy = facts[YY];
        float[] linearX = facts[X];
        float[] linearY = facts[Y];
        float[] constant = facts[CONSTANT];
        float[] conical = facts[CONICAL];
        long hit = 0;
        for (int c = 0; c < count && hit != wanted; c++) {
            if (conical[c] != 0f) {
                FloatVector inX = x.mul(xx[c]).add(y.mul(xy[c])).add(linearX[c]).mul(x);
                FloatVector inY = y.mul(yy[c]).add(linearY[c]).mul(y);
                hit |= wanted
                        & inX.add(inY).compare(VectorOperators.LE, -constant[c]).toLong();
            } else {
                hit |= wanted & blocks(c, discX, discY, sample);
            }
        }
        return hit;
    }

    /** One bit per sample that a candidate blocks: {@link Shadow}'s own test. */
    private long blocks(int candidate, float[] discX, float[] discY, int sample) {
        float a = facts[A][candidate];
        float u = facts[U][candidate];
        float w = facts[W][candidate];
        float radiusSquared = facts[RADIUS_SQUARED][candidate];
        FloatVector x = FloatVector.fromArray(Lanes.FLOATS, discX, sample).mul(scale);
        FloatVector y = FloatVector.fromArray(Lanes.FLOATS, discY, sample).mul(scale);
        FloatVector p = x.mul(-a).add(u);
        FloatVector q = y.mul(-a).add(w);
        FloatVector moment = p.mul(y).sub(q.mul(x));
        FloatVector lengthSquared = x.mul(x).add(y.mul(y)).add(1f);
        VectorMask<Float> met = moment.mul(moment)
                .add(p.mul(p))
                .add(q.mul(q))
                .compare(VectorOperators.LE, lengthSquared.mul(radiusSquared));
        FloatVector along = x.mul(u).add(y.mul(w)).add(a);
        float beyond = distance - a;
        FloatVector beyondU = x.mul(distance).sub(u);
        FloatVector beyondW = y.mul(distance).sub(w);
        FloatVector beyondSquared =
                beyondU.mul(beyondU).add(beyondW.mul(beyondW)).add(beyond * beyond);
        VectorMask<Float> before = along.compare(VectorOperators.LT, lengthSquared.mul(distance))
                .or(beyondSquared.compare(VectorOperators.LT, radiusSquared));
        return met.and(before).and(along.compare(VectorOperators.GT, 0f)).toLong();
    }
}
