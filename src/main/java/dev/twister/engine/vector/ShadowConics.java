package dev.twister.engine.vector;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/**
 * Blocked samples where every candidate lies wholly between the points and the disc. A line through (1, x, y) then
 * decides: it meets the sphere at (a, u, w) where {@code (u y - w x)^2 + (u - a x)^2 + (w - a y)^2 <= r^2 (1 + x^2 + y^2)},
 * a conic in (x, y), so that a sample costs five multiplications a candidate.
 */
final class ShadowConics {
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

    /** Counts the samples that one candidate blocks. */
    static void countOne(ShadowScratch scratch, float[] disc, int samples) {
        float[] candidates = scratch.facts;
        FloatVector xx = Lanes.load(candidates, ShadowScratch.XX);
        FloatVector xy = Lanes.load(candidates, ShadowScratch.XY);
        FloatVector yy = Lanes.load(candidates, ShadowScratch.YY);
        FloatVector x = Lanes.load(candidates, ShadowScratch.X);
        FloatVector y = Lanes.load(candidates, ShadowScratch.Y);
        FloatVector constant = Lanes.load(candidates, ShadowScratch.CONSTANT);
        FloatVector blocked = Lanes.all(0f);
        for (int sample = 0; sample < samples; sample++) {
            FloatVector discX = Lanes.all(disc[2 * sample]);
            FloatVector discY = Lanes.all(disc[2 * sample + 1]);
            FloatVector inX = xy.fma(discY, xx.fma(discX, x)).fma(discX, constant);
            FloatVector conic = yy.fma(discY, y).fma(discY, inX);
            blocked = blocked.blend(blocked.add(1f), conic.compare(VectorOperators.LE, 0f));
        }
        blocked.intoArray(scratch.frame, ShadowScratch.BLOCKED);
    }

    /** Counts the samples that any of the candidates blocks. */
    static void countAny(ShadowScratch scratch, float[] disc, int samples) {
        float[] candidates = scratch.facts;
        FloatVector blocked = Lanes.all(0f);
        for (int sample = 0; sample < samples; sample++) {
            FloatVector discX = Lanes.all(disc[2 * sample]);
            FloatVector discY = Lanes.all(disc[2 * sample + 1]);
            // The lowest conic, not a mask: masks do not live through a loop without becoming objects.
            FloatVector lowest = Lanes.all(1f);
            for (int c = 0; c < scratch.candidates.count; c++) {
                int at = c * ShadowScratch.STRIDE;
                FloatVector linear = Lanes.load(candidates, at + ShadowScratch.XX)
                        .fma(discX, Lanes.load(candidates, at + ShadowScratch.X));
                FloatVector inX = Lanes.load(candidates, at + ShadowScratch.XY)
                        .fma(discY, linear)
                        .fma(discX, Lanes.load(candidates, at + ShadowScratch.CONSTANT));
                FloatVector conic = Lanes.load(candidates, at + ShadowScratch.YY)
                        .fma(discY, Lanes.load(candidates, at + ShadowScratch.Y))
                        .fma(discY, inX);
                lowest = Lanes.smaller(lowest, conic);
            }
            blocked = blocked.blend(blocked.add(1f), lowest.compare(VectorOperators.LE, 0f));
        }
        blocked.intoArray(scratch.frame, ShadowScratch.BLOCKED);
    }
}
