package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.crowd.Leaves;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shortcut.BoundingCone;
import dev.twister.engine.vector.shortcut.ShadowConics;
import dev.twister.engine.vector.shortcut.ShadowRange;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** The visible part of the light at a tile's points. */
public final class Shadows {
    /** Fewer points than this are faster one by one. */
    private static final int FEWEST_TOGETHER = 1 + Lanes.COUNT / 4;

    /** With more leaves on its lines, a packet is handled point by point. */
    private static final int MOST_LEAVES = 36;

    private Shadows() {}

    public static void find(Tile tile, Drawing drawing, ShadowMemory bench) {
        if (tile.shadows.count > 0) {
            if (drawing.crowded) {
                ShadowCandidates.findDiscs(tile, drawing);
                sampleInCrowd(drawing, tile, bench);
            } else {
                BoundingCone hull = bench.hull;
                hull.startAround(tile, tile.shadows, Tile.POINT_X, Tile.SHADOW_OPEN);
                sampleAmongFew(drawing, tile, bench, hull);
            }
        }
    }

    /** As above, for a tile of {@code GroundAlone}. */
    public static void findOnGround(Tile tile, Drawing drawing, ShadowMemory bench, BoundingCone ground) {
        if (tile.shadows.count > 0) {
            sampleAmongFew(drawing, tile, bench, ground);
        }
    }

    private static void sampleAmongFew(Drawing drawing, Tile tile, ShadowMemory bench, BoundingCone hull) {
        hull.listTowardsLight(bench.columns, drawing, drawing.lights[tile.light]);
        if (bench.columns.tileCandidates.count > 0) {
            ShadowCandidates.findDiscs(tile, drawing);
            sample(drawing, tile, bench);
        }
    }

    /**
     * Handles points on the ground and on spheres separately, because the spheres between the two groups may shade
     * neither.
     */
    private static void sampleInCrowd(Drawing drawing, Tile tile, ShadowMemory bench) {
        float radius = drawing.lights[tile.light].discRadius * drawing.rim;
        tile.lonely.clear();
        for (int k = 0; k < tile.shadows.count; k++) {
            int at = tile.shadows.places[k];
            int open = (int) ShadowCandidates.open(tile, at);
            int ground = (int) ShadowCandidates.openOnGround(tile, at);
            if (ground != 0 && ground != open) {
                ShadowCandidates.narrow(tile, at, ground);
                sampleInCrowd(drawing, tile, bench, k, ground, radius);
                open &= ~ground;
                ShadowCandidates.narrow(tile, at, open);
            }
            sampleInCrowd(drawing, tile, bench, k, open, radius);
        }
        PointShadows.find(drawing, tile, bench);
    }

    private static void sampleInCrowd(
            Drawing drawing, Tile tile, ShadowMemory bench, int number, int open, float radius) {
        int at = tile.shadows.places[number];
        SphereColumns near = bench.near;
        int count = ShadowMemory.MOST_NEAR + 1;
        if (Integer.bitCount(open) >= FEWEST_TOGETHER) {
            bench.walks.beam.holdLines(tile, drawing, number, radius);
            count = findNear(drawing.hierarchy, bench);
        }
        if (count > ShadowMemory.MOST_NEAR) {
            tile.lonely.add(at, open);
        } else if (count > ShadowColumns.MOST_TOGETHER) {
            PointShadows.findAmong(near, count, tile, at, drawing, bench);
        } else if (count > 0 && ShadowCandidates.findAmong(near, count, tile, at, drawing, bench)) {
            sample(drawing, tile, bench, at);
        }
    }

    /**
     * Lists the spheres that the beam may meet; returns their number, or any number above
     * {@link ShadowMemory#MOST_NEAR}.
     */
    private static int findNear(WideHierarchy hierarchy, ShadowMemory bench) {
        Leaves leaves = bench.walks.leaves;
        SphereColumns spheres = hierarchy.spheres;
        int count = leaves.find(hierarchy, bench.walks.beam, MOST_LEAVES) ? 0 : ShadowMemory.MOST_NEAR + 1;
        for (int k = leaves.first; k < leaves.end && count <= ShadowMemory.MOST_NEAR; k++) {
            int leaf = leaves.links[k];
            int first = WideHierarchy.firstBlock(leaf);
            for (int left = WideHierarchy.blocks(leaf); left > 0 && count <= ShadowMemory.MOST_NEAR; left--) {
                long met = bench.walks.beam.meeting(spheres, first);
                bench.near.copy(SphereColumns.FIRST + count, spheres, first, met);
                count += Long.bitCount(met);
                first += spheres.step;
            }
        }
        return count;
    }

    private static void sample(Drawing drawing, Tile tile, ShadowMemory bench) {
        if (drawing.looks.transparent && TransmittedLight.isAny(bench.columns, drawing.looks)) {
            for (int k = 0; k < tile.shadows.count; k++) {
                TransmittedLight.find(tile, tile.shadows.places[k], drawing, bench.columns);
            }
            return;
        }
        for (int k = 0; k < tile.shadows.count; k++) {
            int at = tile.shadows.places[k];
            if (ShadowCandidates.find(tile, at, drawing.bodies, bench.columns)) {
                sample(drawing, tile, bench, at);
            }
        }
    }

    /** Counts the samples of a packet with lanes in the penumbra. */
    private static void sample(Drawing drawing, Tile tile, ShadowMemory bench, int at) {
        ShadowFrame.findAxes(tile, at, drawing, bench.columns);
        ShadowFrame.placeAll(tile, at, drawing.bodies, bench.columns);
        ShadowFrame.limitAll(tile, at, drawing.bodies, bench.columns);
        ShadowFrame.judgeAll(tile, at, drawing, bench.columns);
        ShadowConics.prepare(bench.columns);
        ShadowRange.choose(bench.columns, drawing);
        ShadowRange.findPlaces(tile, at, bench.columns);
        ShadowRange.find(bench.columns, drawing);
        count(tile, drawing, bench, at);
        finish(tile, drawing, bench, at);
    }

    /** Writes the number of blocked samples. */
    public static void count(Tile tile, Drawing drawing, ShadowMemory bench, int at) {
        ShadowColumns scratch = bench.columns;
        if (!scratch.conical) {
            ShadowRays.countAny(scratch, tile.values, at + Tile.LIGHT_DISTANCE, drawing.disc, drawing.shadowSamples);
        } else {
            ShadowConics.count(scratch);
        }
    }

    /** Writes the visible parts of the open lanes. */
    public static void finish(Tile tile, Drawing drawing, ShadowMemory bench, int at) {
        float[] t = tile.values;
        FloatVector blocked = Lanes.load(bench.columns.frame, ShadowColumns.BLOCKED);
        FloatVector visible = Lanes.all(1f).sub(blocked.div(drawing.shadowSamples));
        Lanes.load(t, at + Tile.VISIBLE)
                .blend(visible, Lanes.load(t, at + Tile.SHADOW_OPEN).compare(VectorOperators.GT, 0f))
                .intoArray(t, at + Tile.VISIBLE);
    }

    /** Blocked samples in the general case, ray by ray: the test of {@link dev.twister.kernel.Shadow}. */
    private static final class ShadowRays {
        private ShadowRays() {}

        /** Counts the samples that any candidate blocks. */
        static void countAny(ShadowColumns scratch, float[] distances, int at, float[] disc, int samples) {
            FloatVector blocked = Lanes.all(0f);
            for (int sample = 0; sample < samples; sample++) {
                long hit = 0;
                for (int c = 0; c < scratch.candidates.count; c++) {
                    hit |= blocks(
                            scratch, c * ShadowColumns.STRIDE, disc[2 * sample], disc[2 * sample + 1], distances, at);
                }
                blocked = blocked.blend(blocked.add(1f), VectorMask.fromLong(Lanes.FLOATS, hit));
            }
            blocked.intoArray(scratch.frame, ShadowColumns.BLOCKED);
        }

        /** One bit per lane whose sample the candidate blocks. */
        private static long blocks(
                ShadowColumns scratch, int from, float discX, float discY, float[] distances, int at) {
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
}
