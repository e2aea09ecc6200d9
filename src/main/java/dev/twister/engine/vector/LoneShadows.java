package dev.twister.engine.vector;

import dev.twister.kernel.SoftShadow;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * The visible part of the light where the points of a packet have little in common, point by point: lanes hold boxes and
 * spheres on the way through the hierarchy, and samples at its end.
 */
final class LoneShadows {
    private LoneShadows() {}

    /** Writes the visible parts at the packet's open points. */
    static void find(Tile tile, int at, Drawing drawing) {
        float[] t = tile.values;
        for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
            if (t[pixel + Tile.SHADOW_OPEN] > 0f) {
                t[pixel + Tile.VISIBLE] = visible(tile, pixel, drawing);
            }
        }
    }

    private static float visible(Tile tile, int pixel, Drawing drawing) {
        LoneCandidates candidates = tile.shadow.lone;
        candidates.start(tile.values, pixel);
        float visible = 0f;
        if (!walk(tile, pixel, drawing, candidates)) {
            int blocked = candidates.count == 0 ? 0 : count(tile, drawing, candidates);
            visible = 1f - (float) blocked / drawing.shadowSamples;
        }
        return visible;
    }

    /** Lists the candidates; returns whether one of them hides the whole disc. */
    private static boolean walk(Tile tile, int pixel, Drawing drawing, LoneCandidates candidates) {
        WideHierarchy hierarchy = drawing.hierarchy;
        Descent descent = tile.descent;
        Hull hull = tile.shadow.hull;
        hull.holdLines(tile.values, pixel);
        hull.prepareForBoxes();
        descent.start(tile, drawing, hull);
        boolean dark = false;
        int leaf = descent.nextLeaf(tile, drawing, hull, hull.end);
        while (leaf >= 0) {
            int sphere = hierarchy.links[leaf];
            int end = sphere + hierarchy.spheres[leaf];
            while (sphere < end && !dark) {
                long near = LaneSteps.run(LaneSteps.TOUCH_SPHERES, tile, drawing, hull, pixel, sphere)
                        & (1L << Math.min(Lanes.COUNT, end - sphere)) - 1;
                while (near != 0L && !dark) {
                    dark = candidates.judge(hierarchy, sphere + Long.numberOfTrailingZeros(near));
                    near &= near - 1;
                }
                sphere += Lanes.COUNT;
            }
            leaf = dark ? -1 : descent.nextLeaf(tile, drawing, hull, hull.end);
        }
        return dark;
    }

    /** How many samples are blocked. */
    private static int count(Tile tile, Drawing drawing, LoneCandidates candidates) {
        int blocked = 0;
        for (int sample = 0; sample < drawing.shadowSamples; sample += Lanes.COUNT) {
            long wanted = (1L << Math.min(Lanes.COUNT, drawing.shadowSamples - sample)) - 1;
            long hit = 0;
            for (int c = 0; c < candidates.count && hit != wanted; c++) {
                hit |= wanted & LaneSteps.run(LaneSteps.BLOCKS, tile, drawing, tile.shadow.hull, sample, c);
            }
            blocked += Long.bitCount(hit);
        }
        return blocked;
    }

    /** One bit a sample that the candidate blocks: {@link SoftShadow}'s own test. */
    static long blocks(LoneCandidates candidates, int number, Drawing drawing, int sample) {
        int at = number * LoneCandidates.STRIDE;
        float scale = drawing.discRadius / candidates.distance;
        float a = candidates.facts[at];
        float u = candidates.facts[at + 1];
        float w = candidates.facts[at + 2];
        float radiusSquared = candidates.facts[at + 3];
        float distance = candidates.distance;
        FloatVector x = Lanes.load(drawing.discX, sample).mul(scale);
        FloatVector y = Lanes.load(drawing.discY, sample).mul(scale);
        FloatVector p = Lanes.all(u).sub(x.mul(a));
        FloatVector q = Lanes.all(w).sub(y.mul(a));
        FloatVector moment = p.mul(y).sub(q.mul(x));
        FloatVector lengthSquared = x.fma(x, y.fma(y, Lanes.all(1f)));
        VectorMask<Float> met =
                moment.fma(moment, p.fma(p, q.mul(q))).compare(VectorOperators.LE, lengthSquared.mul(radiusSquared));
        FloatVector along = x.mul(u).add(y.mul(w)).add(a);
        float beyond = distance - a;
        FloatVector beyondU = x.mul(distance).sub(u);
        FloatVector beyondW = y.mul(distance).sub(w);
        FloatVector beyondSquared = beyondU.fma(beyondU, beyondW.mul(beyondW)).add(beyond * beyond);
        VectorMask<Float> before = along.compare(VectorOperators.LT, lengthSquared.mul(distance))
                .or(beyondSquared.compare(VectorOperators.LT, radiusSquared));
        return met.and(before).and(along.compare(VectorOperators.GT, 0f)).toLong();
    }
}
