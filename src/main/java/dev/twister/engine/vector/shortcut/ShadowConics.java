package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;

/**
 * Blocked samples where every candidate lies entirely between the points and the disc and is large enough for its
 * distance. In this case the line test suffices: a line through (1, x, y) meets the sphere at (a, u, w) where {@code (u
 * y - w x)^2 + (u - a x)^2 + (w - a y)^2 <= r^2 (1 + x^2 + y^2)}. This is a conic in (x, y) and costs five
 * multiplications per sample and candidate.
 *
 * <p>The loops call the Vector API directly, and of the helpers only {@link Lanes#fma}. C2 may have compiled a larger
 * helper separately before; then it is too large to be inlined, and its vectors become objects, in some runs of the JVM
 * and not in others.
 */
public final class ShadowConics {
    /** Margin, as a factor, for the tests whether a sphere lies entirely between. */
    public static final float WITHIN = 0.9995f;

    /**
     * Largest offset of the light's cone from its axis at the sphere, in radii of the sphere. The conic's coefficients
     * are small differences of large squares; for smaller or more distant spheres too few bits of the squared radius
     * would remain.
     */
    public static final float MOST_RADII_WIDE = 16f;

    /** Offset of the second candidate's data. */
    private static final int SECOND = ShadowColumns.STRIDE;

    /** Shift that turns the sign bit of a negative number, a blocked sample, into 1; faster than compare and blend. */
    private static final int SIGN = 31;

    /** Initial value of the conics: any positive number, which means not blocked. */
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
            // A sphere that cannot shade has a squared radius of -1, so its conic is never negative.
            Lanes.fma(u, u, w.mul(w)).sub(radiusSquared).intoArray(candidates, at + ShadowColumns.CONSTANT);
        }
    }

    /** Adds the samples in the candidates' ranges that any candidate blocks. */
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

    /** Counts the samples that one candidate blocks. */
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
     * As above, for few samples. The count is kept in memory: as a vector carried through a loop with a single
     * iteration it becomes an object in some runs of the JVM.
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
     * Counts the samples that either of two candidates blocks, from the start of the first range to the end of the
     * last.
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

    /** As above, for any number of candidates. */
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

    /** Lowers the stored values of a candidate's samples to its conic. {@code from} is the sample stored first. */
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

    /** Counts the samples whose lowest conic is negative. */
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
