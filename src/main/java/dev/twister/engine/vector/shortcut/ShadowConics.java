package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;

/**
 * Blocked samples where every candidate lies wholly between the points and the disc, and is not small for its distance.
 * A line through (1, x, y) then decides: it meets the sphere at (a, u, w) where {@code (u y - w x)^2 + (u - a x)^2 + (w
 * - a y)^2 <= r^2 (1 + x^2 + y^2)}, a conic in (x, y), so that a sample costs five multiplications a candidate.
 *
 * <p>The loops call the Vector API itself, and of helpers {@link Lanes#fma} alone: one of several operations that the
 * compiler has met first on its own may be too large to be inlined, and its vectors become objects, in some JVMs and
 * not in others.
 */
public final class ShadowConics {
    /** Of a sphere that counts as wholly between: so much farther within than it need be, as rounding may be wrong. */
    public static final float WITHIN = 0.9995f;

    /**
     * How many of its own radii the light's cone may reach off its axis where a sphere is. A conic's numbers are
     * squares of the sphere's place, and small differences of large ones: of a smaller sphere farther off too little
     * would be left of the squared radius.
     */
    public static final float MOST_RADII_WIDE = 16f;

    /** Where the second candidate's facts begin. */
    private static final int SECOND = ShadowColumns.STRIDE;

    /**
     * From the bit of a number below 0, where a sample is blocked, to a 1: fewer steps than to compare and to choose.
     */
    private static final int SIGN = 31;

    /** A conic where nothing blocks: any number above 0. */
    private static final float ABOVE = 1f;

    private ShadowConics() {}

    /** Writes each candidate's conic over the unit disc. */
    public static void prepare(ShadowColumns scratch) {
        float[] candidates = scratch.facts;
        for (int c = 0; c < scratch.candidates.count; c++) {
            int at = c * ShadowColumns.STRIDE;
            FloatVector scale = Lanes.load(scratch.frame, ShadowColumns.SCALE);
            FloatVector a = Lanes.load(candidates, at + ShadowColumns.ALONG).mul(scale);
            FloatVector u = Lanes.load(candidates, at + ShadowColumns.ACROSS_U);
            FloatVector w = Lanes.load(candidates, at + ShadowColumns.ACROSS_W);
            FloatVector radiusSquared = Lanes.load(candidates, at + ShadowColumns.RADIUS_SQUARED);
            FloatVector scaledU = u.mul(scale);
            FloatVector scaledW = w.mul(scale);
            FloatVector rest = a.mul(a).sub(radiusSquared.mul(scale).mul(scale));
            Lanes.fma(scaledW, scaledW, rest).intoArray(candidates, at + ShadowColumns.XX);
            scaledU.mul(scaledW).mul(-2f).intoArray(candidates, at + ShadowColumns.XY);
            Lanes.fma(scaledU, scaledU, rest).intoArray(candidates, at + ShadowColumns.YY);
            a.mul(u).mul(-2f).intoArray(candidates, at + ShadowColumns.X);
            a.mul(w).mul(-2f).intoArray(candidates, at + ShadowColumns.Y);
            // No sphere that cannot shade has a conic below 0: its squared radius counts as -1.
            Lanes.fma(u, u, w.mul(w)).sub(radiusSquared).intoArray(candidates, at + ShadowColumns.CONSTANT);
        }
    }

    /** Adds the samples in the candidates' ranges that any of them blocks. */
    public static void count(ShadowColumns scratch) {
        if (ShadowRange.areApart(scratch)) {
            for (int c = 0; c < scratch.candidates.count; c++) {
                if (scratch.sorted) {
                    countOne(scratch, c);
                } else {
                    countFew(scratch, c);
                }
            }
        } else if (scratch.candidates.count == 2) {
            countTwo(scratch);
        } else {
            countAny(scratch);
        }
    }

    /** Those of one candidate. */
    static void countOne(ShadowColumns scratch, int candidate) {
        float[] facts = scratch.facts;
        float[] disc = scratch.disc;
        int to = 2 * scratch.tos[candidate];
        int of = candidate * ShadowColumns.STRIDE;
        FloatVector xx = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.XX);
        FloatVector xy = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.XY);
        FloatVector yy = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.YY);
        FloatVector linearX = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.X);
        FloatVector linearY = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.Y);
        FloatVector constant = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.CONSTANT);
        IntVector blocked = IntVector.zero(Lanes.INTS);
        for (int at = 2 * scratch.froms[candidate]; at < to; at += 2) {
            FloatVector x = FloatVector.broadcast(Lanes.FLOATS, disc[at]);
            FloatVector y = FloatVector.broadcast(Lanes.FLOATS, disc[at + 1]);
            FloatVector inX = Lanes.fma(Lanes.fma(xy, y, Lanes.fma(xx, x, linearX)), x, constant);
            FloatVector conic = Lanes.fma(Lanes.fma(yy, y, linearY), y, inX);
            blocked = blocked.add(conic.reinterpretAsInts().lanewise(VectorOperators.LSHR, SIGN));
        }
        Lanes.toFloats(blocked)
                .add(FloatVector.fromArray(Lanes.FLOATS, scratch.frame, ShadowColumns.BLOCKED))
                .intoArray(scratch.frame, ShadowColumns.BLOCKED);
    }

    /**
     * Those of one candidate where they are few. The count stays in memory: as a vector that a loop of one round hands
     * on, it would become an object in some JVMs.
     */
    static void countFew(ShadowColumns scratch, int candidate) {
        float[] facts = scratch.facts;
        float[] disc = scratch.disc;
        int to = 2 * scratch.tos[candidate];
        int of = candidate * ShadowColumns.STRIDE;
        FloatVector xx = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.XX);
        FloatVector xy = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.XY);
        FloatVector yy = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.YY);
        FloatVector linearX = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.X);
        FloatVector linearY = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.Y);
        FloatVector constant = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.CONSTANT);
        for (int at = 2 * scratch.froms[candidate]; at < to; at += 2) {
            FloatVector x = FloatVector.broadcast(Lanes.FLOATS, disc[at]);
            FloatVector y = FloatVector.broadcast(Lanes.FLOATS, disc[at + 1]);
            FloatVector inX = Lanes.fma(Lanes.fma(xy, y, Lanes.fma(xx, x, linearX)), x, constant);
            FloatVector conic = Lanes.fma(Lanes.fma(yy, y, linearY), y, inX);
            Lanes.toFloats(conic.reinterpretAsInts().lanewise(VectorOperators.LSHR, SIGN))
                    .add(FloatVector.fromArray(Lanes.FLOATS, scratch.frame, ShadowColumns.BLOCKED))
                    .intoArray(scratch.frame, ShadowColumns.BLOCKED);
        }
    }

    /**
     * Adds the samples that any of two candidates blocks, of those from where the first range begins to where the last
     * ends.
     */
    private static void countTwo(ShadowColumns scratch) {
        float[] facts = scratch.facts;
        float[] disc = scratch.disc;
        int to = 2 * Math.max(scratch.tos[0], scratch.tos[1]);
        FloatVector xx = FloatVector.fromArray(Lanes.FLOATS, facts, ShadowColumns.XX);
        FloatVector xy = FloatVector.fromArray(Lanes.FLOATS, facts, ShadowColumns.XY);
        FloatVector yy = FloatVector.fromArray(Lanes.FLOATS, facts, ShadowColumns.YY);
        FloatVector linearX = FloatVector.fromArray(Lanes.FLOATS, facts, ShadowColumns.X);
        FloatVector linearY = FloatVector.fromArray(Lanes.FLOATS, facts, ShadowColumns.Y);
        FloatVector constant = FloatVector.fromArray(Lanes.FLOATS, facts, ShadowColumns.CONSTANT);
        FloatVector xxToo = FloatVector.fromArray(Lanes.FLOATS, facts, SECOND + ShadowColumns.XX);
        FloatVector xyToo = FloatVector.fromArray(Lanes.FLOATS, facts, SECOND + ShadowColumns.XY);
        FloatVector yyToo = FloatVector.fromArray(Lanes.FLOATS, facts, SECOND + ShadowColumns.YY);
        FloatVector linearXToo = FloatVector.fromArray(Lanes.FLOATS, facts, SECOND + ShadowColumns.X);
        FloatVector linearYToo = FloatVector.fromArray(Lanes.FLOATS, facts, SECOND + ShadowColumns.Y);
        FloatVector constantToo = FloatVector.fromArray(Lanes.FLOATS, facts, SECOND + ShadowColumns.CONSTANT);
        IntVector blocked = IntVector.zero(Lanes.INTS);
        for (int at = 2 * Math.min(scratch.froms[0], scratch.froms[1]); at < to; at += 2) {
            FloatVector x = FloatVector.broadcast(Lanes.FLOATS, disc[at]);
            FloatVector y = FloatVector.broadcast(Lanes.FLOATS, disc[at + 1]);
            FloatVector inX = Lanes.fma(Lanes.fma(xy, y, Lanes.fma(xx, x, linearX)), x, constant);
            FloatVector inXToo = Lanes.fma(Lanes.fma(xyToo, y, Lanes.fma(xxToo, x, linearXToo)), x, constantToo);
            FloatVector conic = Lanes.fma(Lanes.fma(yy, y, linearY), y, inX);
            FloatVector conicToo = Lanes.fma(Lanes.fma(yyToo, y, linearYToo), y, inXToo);
            IntVector signs = conic.reinterpretAsInts().or(conicToo.reinterpretAsInts());
            blocked = blocked.add(signs.lanewise(VectorOperators.LSHR, SIGN));
        }
        Lanes.toFloats(blocked)
                .add(FloatVector.fromArray(Lanes.FLOATS, scratch.frame, ShadowColumns.BLOCKED))
                .intoArray(scratch.frame, ShadowColumns.BLOCKED);
    }

    /** The same with any number of candidates. */
    private static void countAny(ShadowColumns scratch) {
        int from = Integer.MAX_VALUE;
        int to = 0;
        for (int c = 0; c < scratch.candidates.count; c++) {
            from = Math.min(from, scratch.froms[c]);
            to = Math.max(to, scratch.tos[c]);
        }
        int samples = to - from;
        scratch.reserveConics(samples);
        Arrays.fill(scratch.conics, Lanes.BORDER, Lanes.BORDER + samples * Lanes.COUNT, ABOVE);
        for (int c = 0; c < scratch.candidates.count; c++) {
            lower(scratch, from, c);
        }
        countLowest(scratch, samples);
    }

    /**
     * Lowers what is there at each sample of a candidate's range to its conic, the first sample there being that one.
     */
    static void lower(ShadowColumns scratch, int from, int candidate) {
        int of = candidate * ShadowColumns.STRIDE;
        float[] facts = scratch.facts;
        float[] disc = scratch.disc;
        float[] conics = scratch.conics;
        FloatVector xx = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.XX);
        FloatVector xy = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.XY);
        FloatVector yy = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.YY);
        FloatVector linearX = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.X);
        FloatVector linearY = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.Y);
        FloatVector constant = FloatVector.fromArray(Lanes.FLOATS, facts, of + ShadowColumns.CONSTANT);
        int to = scratch.tos[candidate] - from;
        for (int sample = scratch.froms[candidate] - from; sample < to; sample++) {
            FloatVector x = FloatVector.broadcast(Lanes.FLOATS, disc[2 * (from + sample)]);
            FloatVector y = FloatVector.broadcast(Lanes.FLOATS, disc[2 * (from + sample) + 1]);
            FloatVector inX = Lanes.fma(Lanes.fma(xy, y, Lanes.fma(xx, x, linearX)), x, constant);
            FloatVector conic = Lanes.fma(Lanes.fma(yy, y, linearY), y, inX);
            FloatVector before = FloatVector.fromArray(Lanes.FLOATS, conics, Lanes.BORDER + sample * Lanes.COUNT);
            conic.blend(before, before.compare(VectorOperators.LT, conic))
                    .intoArray(conics, Lanes.BORDER + sample * Lanes.COUNT);
        }
    }

    /** Counts the samples at which the lowest conic is below 0. */
    static void countLowest(ShadowColumns scratch, int samples) {
        float[] conics = scratch.conics;
        IntVector blocked = IntVector.zero(Lanes.INTS);
        for (int sample = 0; sample < samples; sample++) {
            FloatVector conic = FloatVector.fromArray(Lanes.FLOATS, conics, Lanes.BORDER + sample * Lanes.COUNT);
            blocked = blocked.add(conic.reinterpretAsInts().lanewise(VectorOperators.LSHR, SIGN));
        }
        Lanes.toFloats(blocked)
                .add(FloatVector.fromArray(Lanes.FLOATS, scratch.frame, ShadowColumns.BLOCKED))
                .intoArray(scratch.frame, ShadowColumns.BLOCKED);
    }
}
