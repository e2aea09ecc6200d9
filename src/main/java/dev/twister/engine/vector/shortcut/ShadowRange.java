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
 * Which samples are to be looked at, in the order along one of {@link DiscOrders}' directions. A candidate's shadow
 * begins and ends somewhere along it, and what lies before and behind is free of it; and from some place on it may hide
 * all.
 *
 * <p>The planes through the point that touch the sphere at (a, u, w) and are across the direction meet the disc's plane
 * at {@code (a c -+ r sqrt(a^2 + c^2 - r^2)) / (a^2 - r^2) / s} radii from its center, c being the sphere's center
 * along the direction and s the scale: the shadow lies between them. And the conic of {@link ShadowConics} is nowhere
 * in the unit disc above {@code s^2 (a^2 + u^2 + w^2 - r^2) + u^2 + w^2 - r^2 + 2 a s (|l| - c X)} at X along the
 * direction, l being the center's place beside it: that is below 0 on one side of some X.
 */
public final class ShadowRange {
    /**
     * By how much more of the disc's radius a shadow begins sooner, ends later and hides all later, as rounding may be
     * wrong.
     */
    private static final float MARGIN = 2e-3f;

    /** Where the point is so near to the sphere, as a part of its squared radius, that the shadow may have no end. */
    private static final float NEAR = 1.01f;

    /** Along a direction, a place behind all samples; and before them with the other sign. */
    private static final float BEYOND = 2f;

    private ShadowRange() {}

    /** Chooses the direction, from the disc's center to the first candidate as one of the packet's points sees it. */
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

    /** Writes where each candidate's shadow begins and ends, and where it hides all, as each lane sees it. */
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
     * Finds the range of each candidate's samples that are to be looked at, and counts those that are hidden from all
     * lanes without a look.
     */
    public static void find(ShadowColumns scratch, Drawing drawing) {
        if (scratch.sorted) {
            findRanges(drawing.discOrders, drawing.shadowSamples, scratch);
        } else {
            scratch.disc = drawing.input.view().shadowDisc();
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

    /** Whether no sample is to be looked at for two candidates: each may then be counted by itself. */
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
