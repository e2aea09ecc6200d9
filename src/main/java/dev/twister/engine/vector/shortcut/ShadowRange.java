package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.DiscOrders;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Shortcut;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * The range of samples to test, in the order along one direction of {@link DiscOrders}. A candidate's shadow covers an
 * interval along it. Samples outside are visible, and beyond some position all samples may be blocked.
 *
 * <p>The planes through the point that touch the sphere at (a, u, w) and are perpendicular to the direction meet the
 * disc's plane at {@code (a c -+ r sqrt(a^2 + c^2 - r^2)) / (a^2 - r^2) / s} radii from its center, where c is the
 * sphere's center along the direction and s the scale. The shadow lies between them. Within the unit disc the conic of
 * {@link ShadowConics} is at most {@code s^2 (a^2 + u^2 + w^2 - r^2) + u^2 + w^2 - r^2 + 2 a s (|l| - c X)} at X along
 * the direction, where l is the center's position across it. This bound is negative on one side of some X.
 */
public final class ShadowRange {
    /**
     * Margin for rounding, in disc radii, by which intervals of shadow are widened and those of full shadow narrowed.
     */
    private static final float MARGIN = 2e-3f;

    /** With a squared distance below this many squared radii, the shadow may be unbounded. */
    private static final float NEAR = 1.01f;

    /** A position beyond all samples along a direction; negated, one before all samples. */
    private static final float BEYOND = 2f;

    private ShadowRange() {}

    /** Chooses the direction from the disc's center to the first candidate, seen from one of the packet's points. */
    public static void choose(ShadowColumns scratch, Drawing drawing) {
        scratch.sorted = scratch.conical
                && drawing.shadowSamples >= DiscOrders.FEW
                && drawing.shortcuts.take(Shortcut.SAMPLE_RANGES);
        if (scratch.sorted) {
            int lane = Long.numberOfTrailingZeros(scratch.touched & ~scratch.dark);
            scratch.direction = DiscOrders.nearest(
                    scratch.facts[ShadowColumns.ACROSS_U + lane], scratch.facts[ShadowColumns.ACROSS_W + lane]);
        }
    }

    /** Writes each candidate's interval of shadow and of full shadow, per lane. */
    public static void findPlaces(Tile tile, int at, ShadowColumns scratch) {
        if (scratch.sorted) {
            for (int c = 0; c < scratch.candidates.count; c++) {
                findPlaces(tile.values, at, scratch, c * ShadowColumns.STRIDE);
            }
        }
    }

    private static void findPlaces(float[] t, int at, ShadowColumns scratch, int of) {
        float[] facts = scratch.facts;
        float alongU = DiscOrders.alongU(scratch.direction);
        float alongW = DiscOrders.alongW(scratch.direction);
        FloatVector scale = FloatVector.fromArray(Lanes.FLOATS, scratch.frame, ShadowColumns.SCALE);
        FloatVector a = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.ALONG);
        FloatVector u = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.ACROSS_U);
        FloatVector w = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.ACROSS_W);
        FloatVector radiusSquared = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.RADIUS_SQUARED);
        FloatVector center = u.mul(alongU).add(w.mul(alongW));
        FloatVector beside = w.mul(alongU).sub(u.mul(alongW)).abs();
        FloatVector past = a.mul(a).sub(radiusSquared);
        FloatVector middle = a.mul(center);
        FloatVector half = center.mul(center).add(past).mul(radiusSquared).sqrt();
        FloatVector inverse = FloatVector.broadcast(Lanes.FLOATS, 1f).div(past.mul(scale));
        VectorMask<Float> endless = a.mul(a).compare(VectorOperators.LE, radiusSquared.mul(NEAR));
        VectorMask<Float> harmless = radiusSquared.compare(VectorOperators.LT, 0f);
        middle.sub(half)
                .mul(inverse)
                .sub(MARGIN)
                .blend(-BEYOND, endless)
                .blend(BEYOND, harmless)
                .intoArray(facts, of + ShadowColumns.BEGIN);
        middle.add(half)
                .mul(inverse)
                .add(MARGIN)
                .blend(BEYOND, endless)
                .blend(-BEYOND, harmless)
                .intoArray(facts, of + ShadowColumns.END);
        FloatVector across = u.mul(u).add(w.mul(w)).sub(radiusSquared);
        FloatVector twice = a.mul(scale).mul(2f);
        FloatVector highest =
                a.mul(a).add(across).mul(scale).mul(scale).add(across).add(twice.mul(beside));
        FloatVector below = highest.div(twice.mul(center));
        VectorMask<Float> closed =
                FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SHADOW_OPEN).compare(VectorOperators.LE, 0f);
        below.add(MARGIN)
                .blend(BEYOND, center.compare(VectorOperators.LE, 0f))
                .blend(BEYOND, harmless)
                .blend(-BEYOND, closed)
                .intoArray(facts, of + ShadowColumns.HIDDEN_FROM);
        below.sub(MARGIN)
                .blend(-BEYOND, center.compare(VectorOperators.GE, 0f))
                .blend(-BEYOND, harmless)
                .blend(BEYOND, closed)
                .intoArray(facts, of + ShadowColumns.HIDDEN_TO);
    }

    /**
     * Finds the range of samples to test per candidate, and counts those that are blocked in all lanes without a test.
     */
    public static void find(ShadowColumns scratch, Drawing drawing) {
        if (scratch.sorted) {
            findRanges(drawing.discOrders, drawing.shadowSamples, scratch);
        } else {
            scratch.disc = drawing.disc;
            Lanes.all(0f).intoArray(scratch.frame, ShadowColumns.BLOCKED);
            Arrays.fill(scratch.froms, 0, scratch.candidates.count, 0);
            Arrays.fill(scratch.tos, 0, scratch.candidates.count, drawing.shadowSamples);
        }
    }

    private static void findRanges(DiscOrders orders, int samples, ShadowColumns scratch) {
        int direction = scratch.direction;
        int count = scratch.candidates.count;
        int from = 0;
        int to = samples;
        for (int c = 0; c < count; c++) {
            int at = c * ShadowColumns.STRIDE;
            scratch.froms[c] = orders.before(direction, least(scratch, at + ShadowColumns.BEGIN));
            scratch.tos[c] = orders.upTo(direction, greatest(scratch, at + ShadowColumns.END));
            from = Math.max(from, orders.before(direction, least(scratch, at + ShadowColumns.HIDDEN_TO)));
            to = Math.min(to, orders.upTo(direction, greatest(scratch, at + ShadowColumns.HIDDEN_FROM)));
        }
        to = Math.max(from, to);
        int first = orders.first(direction);
        for (int c = 0; c < count; c++) {
            scratch.froms[c] = first + Math.clamp(scratch.froms[c], from, to);
            scratch.tos[c] = Math.max(scratch.froms[c], first + Math.clamp(scratch.tos[c], from, to));
        }
        scratch.disc = orders.samples;
        Lanes.all(from + samples - to).intoArray(scratch.frame, ShadowColumns.BLOCKED);
    }

    /**
     * Whether the candidates' ranges do not overlap, so that each can be counted separately. Only up to two candidates.
     */
    static boolean areApart(ShadowColumns scratch) {
        int count = scratch.candidates.count;
        return count == 1
                || (count == 2
                        && Math.max(scratch.froms[0], scratch.froms[1]) >= Math.min(scratch.tos[0], scratch.tos[1]));
    }

    private static float least(ShadowColumns scratch, int at) {
        return Lanes.least(Lanes.load(scratch.facts, at));
    }

    private static float greatest(ShadowColumns scratch, int at) {
        return Lanes.greatest(Lanes.load(scratch.facts, at));
    }
}
