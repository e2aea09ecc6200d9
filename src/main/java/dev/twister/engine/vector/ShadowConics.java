package dev.twister.engine.vector;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/**
 * Blocked samples where every candidate lies wholly between the points and the disc. A line through (1, x, y) then
 * decides: it meets the sphere at (a, u, w) where {@code (u y - w x)^2 + (u - a x)^2 + (w - a y)^2 <= r^2 (1 + x^2 + y^2)},
 * a conic in (x, y), so that a sample costs five multiplications a candidate.
 */
final class ShadowConics {
    private static final int FIRST = 0;
    private static final int FURTHER = 1;
    private static final int COUNT = 2;

    /** By the numbers above; in an array, so that each keeps its own inlining budget: see {@link Stage}. */
    private static final Pass[] PASSES = {
        (scratch, disc, samples, from) -> start(scratch, disc, samples, from),
        (scratch, disc, samples, from) -> lower(scratch, disc, samples, from),
        (scratch, disc, samples, from) -> count(scratch, samples),
    };

    private ShadowConics() {}

    /** Writes each candidate's conic over the unit disc. */
    static void prepare(ShadowScratch scratch) {
        float[] candidates = scratch.facts;
        for (int c = 0; c < scratch.candidates.count; c++) {
            int at = c * ShadowScratch.STRIDE;
            FloatVector scale = Lanes.load(scratch.frame, ShadowScratch.SCALE);
            FloatVector a = Lanes.load(candidates, at + ShadowScratch.ALONG).mul(scale);
            FloatVector u = Lanes.load(candidates, at + ShadowScratch.ACROSS_U);
            FloatVector w = Lanes.load(candidates, at + ShadowScratch.ACROSS_W);
            FloatVector radiusSquared = Lanes.load(candidates, at + ShadowScratch.RADIUS_SQUARED);
            FloatVector scaledU = u.mul(scale);
            FloatVector scaledW = w.mul(scale);
            FloatVector rest = a.mul(a).sub(radiusSquared.mul(scale).mul(scale));
            scaledW.fma(scaledW, rest).intoArray(candidates, at + ShadowScratch.XX);
            scaledU.mul(scaledW).mul(-2f).intoArray(candidates, at + ShadowScratch.XY);
            scaledU.fma(scaledU, rest).intoArray(candidates, at + ShadowScratch.YY);
            a.mul(u).mul(-2f).intoArray(candidates, at + ShadowScratch.X);
            a.mul(w).mul(-2f).intoArray(candidates, at + ShadowScratch.Y);
            // No sphere that cannot shade has a conic below 0: its squared radius counts as -1.
            u.fma(u, w.mul(w)).sub(radiusSquared).intoArray(candidates, at + ShadowScratch.CONSTANT);
        }
    }

    /** Counts the samples that one candidate blocks, two by two, as each addition waits for the one before. */
    static void countOne(ShadowScratch scratch, float[] disc, int samples) {
        float[] candidates = scratch.facts;
        FloatVector xx = Lanes.load(candidates, ShadowScratch.XX);
        FloatVector xy = Lanes.load(candidates, ShadowScratch.XY);
        FloatVector yy = Lanes.load(candidates, ShadowScratch.YY);
        FloatVector x = Lanes.load(candidates, ShadowScratch.X);
        FloatVector y = Lanes.load(candidates, ShadowScratch.Y);
        FloatVector constant = Lanes.load(candidates, ShadowScratch.CONSTANT);
        FloatVector blocked = Lanes.all(0f);
        FloatVector blockedToo = Lanes.all(0f);
        for (int at = 0; at + 2 < 2 * samples; at += 4) {
            FloatVector conic = conic(xx, xy, yy, x, y, constant, disc[at], disc[at + 1]);
            FloatVector conicToo = conic(xx, xy, yy, x, y, constant, disc[at + 2], disc[at + 3]);
            blocked = counted(blocked, conic);
            blockedToo = counted(blockedToo, conicToo);
        }
        if (samples % 2 != 0) {
            FloatVector conic = conic(xx, xy, yy, x, y, constant, disc[2 * samples - 2], disc[2 * samples - 1]);
            blocked = counted(blocked, conic);
        }
        blocked.add(blockedToo).intoArray(scratch.frame, ShadowScratch.BLOCKED);
    }

    private static FloatVector conic(
            FloatVector xx,
            FloatVector xy,
            FloatVector yy,
            FloatVector x,
            FloatVector y,
            FloatVector constant,
            float discX,
            float discY) {
        FloatVector placeX = Lanes.all(discX);
        FloatVector placeY = Lanes.all(discY);
        FloatVector inX = xy.fma(placeY, xx.fma(placeX, x)).fma(placeX, constant);
        return yy.fma(placeY, y).fma(placeY, inX);
    }

    private static FloatVector counted(FloatVector blocked, FloatVector conic) {
        return blocked.blend(blocked.add(1f), conic.compare(VectorOperators.LE, 0f));
    }

    /** Counts the samples that any of the candidates blocks. */
    static void countAny(ShadowScratch scratch, float[] disc, int samples) {
        scratch.reserveConics(samples);
        PASSES[FIRST].run(scratch, disc, samples, 0);
        for (int c = 1; c < scratch.candidates.count; c++) {
            PASSES[FURTHER].run(scratch, disc, samples, c * ShadowScratch.STRIDE);
        }
        PASSES[COUNT].run(scratch, disc, samples, 0);
    }

    /** Writes a candidate's conic at each sample. */
    private static void start(ShadowScratch scratch, float[] disc, int samples, int from) {
        float[] facts = scratch.facts;
        FloatVector xx = Lanes.load(facts, from + ShadowScratch.XX);
        FloatVector xy = Lanes.load(facts, from + ShadowScratch.XY);
        FloatVector yy = Lanes.load(facts, from + ShadowScratch.YY);
        FloatVector x = Lanes.load(facts, from + ShadowScratch.X);
        FloatVector y = Lanes.load(facts, from + ShadowScratch.Y);
        FloatVector constant = Lanes.load(facts, from + ShadowScratch.CONSTANT);
        for (int sample = 0; sample < samples; sample++) {
            conic(xx, xy, yy, x, y, constant, disc[2 * sample], disc[2 * sample + 1])
                    .intoArray(scratch.conics, sample * Lanes.COUNT);
        }
    }

    /** Lowers what is there at each sample to a further candidate's conic. */
    private static void lower(ShadowScratch scratch, float[] disc, int samples, int from) {
        float[] facts = scratch.facts;
        float[] conics = scratch.conics;
        FloatVector xx = Lanes.load(facts, from + ShadowScratch.XX);
        FloatVector xy = Lanes.load(facts, from + ShadowScratch.XY);
        FloatVector yy = Lanes.load(facts, from + ShadowScratch.YY);
        FloatVector x = Lanes.load(facts, from + ShadowScratch.X);
        FloatVector y = Lanes.load(facts, from + ShadowScratch.Y);
        FloatVector constant = Lanes.load(facts, from + ShadowScratch.CONSTANT);
        for (int sample = 0; sample < samples; sample++) {
            FloatVector conic = conic(xx, xy, yy, x, y, constant, disc[2 * sample], disc[2 * sample + 1]);
            Lanes.smaller(Lanes.load(conics, sample * Lanes.COUNT), conic).intoArray(conics, sample * Lanes.COUNT);
        }
    }

    /** Counts the samples at which the lowest conic is not above 0. */
    private static void count(ShadowScratch scratch, int samples) {
        FloatVector blocked = Lanes.all(0f);
        for (int sample = 0; sample < samples; sample++) {
            blocked = counted(blocked, Lanes.load(scratch.conics, sample * Lanes.COUNT));
        }
        blocked.intoArray(scratch.frame, ShadowScratch.BLOCKED);
    }

    /** One way over all samples. */
    @FunctionalInterface
    private interface Pass {
        void run(ShadowScratch scratch, float[] disc, int samples, int from);
    }
}
