package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Blocked samples in the general case, ray by ray: the test of {@link dev.twister.kernel.Shadow}. */
public final class ShadowRays {
    private ShadowRays() {}

    /** Counts the samples that any candidate blocks. */
    static void countAny(ShadowColumns scratch, float[] distances, int at, float[] disc, int samples) {
        FloatVector blocked = Lanes.all(0f);
        for (int sample = 0; sample < samples; sample++) {
            long hit = 0;
            for (int c = 0; c < scratch.candidates.count; c++) {
                hit |= blocks(scratch, c * ShadowColumns.STRIDE, disc[2 * sample], disc[2 * sample + 1], distances, at);
            }
            blocked = blocked.blend(blocked.add(1f), VectorMask.fromLong(Lanes.FLOATS, hit));
        }
        blocked.intoArray(scratch.frame, ShadowColumns.BLOCKED);
    }

    /** One bit per lane whose sample the candidate blocks. */
    private static long blocks(ShadowColumns scratch, int from, float discX, float discY, float[] distances, int at) {
        float[] candidates = scratch.facts;
        FloatVector scale = Lanes.load(scratch.frame, ShadowColumns.SCALE);
        FloatVector distance = Lanes.load(distances, at);
        FloatVector x = scale.mul(discX);
        FloatVector y = scale.mul(discY);
        FloatVector a = Lanes.load(candidates, from + ShadowColumns.ALONG);
        FloatVector u = Lanes.load(candidates, from + ShadowColumns.ACROSS_U);
        FloatVector w = Lanes.load(candidates, from + ShadowColumns.ACROSS_W);
        FloatVector radiusSquared = Lanes.load(candidates, from + ShadowColumns.RADIUS_SQUARED);
        FloatVector p = u.sub(a.mul(x));
        FloatVector q = w.sub(a.mul(y));
        FloatVector moment = p.mul(y).sub(q.mul(x));
        FloatVector lengthSquared = Lanes.fma(x, x, Lanes.fma(y, y, Lanes.all(1f)));
        VectorMask<Float> met = Lanes.fma(moment, moment, Lanes.fma(p, p, q.mul(q)))
                .compare(VectorOperators.LE, radiusSquared.mul(lengthSquared));
        FloatVector along = Lanes.fma(x, u, Lanes.fma(y, w, a));
        FloatVector beyondA = distance.sub(a);
        FloatVector beyondU = distance.mul(x).sub(u);
        FloatVector beyondW = distance.mul(y).sub(w);
        FloatVector beyondSquared = Lanes.fma(beyondA, beyondA, Lanes.fma(beyondU, beyondU, beyondW.mul(beyondW)));
        VectorMask<Float> before = along.compare(VectorOperators.LT, distance.mul(lengthSquared))
                .or(beyondSquared.compare(VectorOperators.LT, radiusSquared));
        return met.and(before).and(along.compare(VectorOperators.GT, 0f)).toLong();
    }
}
