package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** The visible part of the light at the points of a tile. */
final class Shadows {
    /** Fewer points than these are better off one by one from the start. */
    private static final int FEWEST_TOGETHER = 1 + Lanes.COUNT / 4;

    /** Where more spheres are near a packet's lines, its points are better off one by one. */
    static final int MOST_TOGETHER = 32;

    /** Where more are near, each point looks for its own. */
    static final int MOST_NEAR = 256;

    /** Where its lines meet more leaves, they are not even looked into. */
    private static final int MOST_LEAVES = 36;

    private Shadows() {}

    static void find(Tile tile, Drawing drawing) {
        if (tile.shadows.count > 0) {
            if (drawing.crowded) {
                ShadowCandidates.findDiscs(tile, drawing);
                sampleInCrowd(tile, drawing);
            } else {
                Hull hull = tile.shadow.hull;
                hull.startAround(tile, tile.shadows, Tile.POINT_X, Tile.SHADOW_OPEN);
                sampleAmongFew(tile, drawing, hull);
            }
        }
    }

    /** The same for a tile of {@link GroundAlone}. */
    static void findOnGround(Tile tile, Drawing drawing) {
        if (tile.shadows.count > 0) {
            sampleAmongFew(tile, drawing, tile.ground);
        }
    }

    private static void sampleAmongFew(Tile tile, Drawing drawing, Hull hull) {
        listBetween(hull, tile, drawing);
        if (tile.shadow.tileCandidates.count > 0) {
            ShadowCandidates.findDiscs(tile, drawing);
            sample(tile, drawing);
        }
    }

    /** Lists the spheres that may come between the light and what the hull, which is made to end at the light, starts around. */
    static void listBetween(Hull hull, Tile tile, Drawing drawing) {
        BodyColumns bodies = drawing.bodies;
        hull.endIn(
                bodies.x[Layout.LIGHT],
                bodies.y[Layout.LIGHT],
                bodies.z[Layout.LIGHT],
                drawing.discRadius * drawing.rim);
        hull.cull(drawing.bodies, Layout.FIRST_SPHERE, tile.shadow.tileCandidates);
    }

    /** Points on the ground and on spheres are looked at apart: between them there are many spheres that shade neither. */
    private static void sampleInCrowd(Tile tile, Drawing drawing) {
        float radius = drawing.discRadius * drawing.rim;
        tile.lonely.clear();
        for (int k = 0; k < tile.shadows.count; k++) {
            int at = tile.shadows.places[k];
            int open = (int) ShadowCandidates.open(tile.values, at);
            int ground = (int) ShadowCandidates.openOnGround(tile.values, at);
            if (ground != 0 && ground != open) {
                ShadowCandidates.narrow(tile.values, at, ground);
                sampleInCrowd(tile, drawing, k, ground, radius);
                open &= ~ground;
                ShadowCandidates.narrow(tile.values, at, open);
            }
            sampleInCrowd(tile, drawing, k, open, radius);
        }
        LoneShadows.find(tile, drawing);
    }

    private static void sampleInCrowd(Tile tile, Drawing drawing, int number, int open, float radius) {
        int at = tile.shadows.places[number];
        SphereColumns near = tile.near;
        int count = MOST_NEAR + 1;
        if (Integer.bitCount(open) >= FEWEST_TOGETHER) {
            tile.beam.holdLines(tile, drawing, number, radius);
            count = findNear(tile, drawing.hierarchy);
        }
        if (count > MOST_NEAR) {
            tile.lonely.add(at, open);
        } else if (count > MOST_TOGETHER) {
            LoneShadows.findAmong(near, count, tile, at, drawing);
        } else if (count > 0 && ShadowCandidates.findAmong(near, count, tile, at, drawing)) {
            sample(tile, drawing, at);
        }
    }

    /** Lists the spheres that the beam may meet; returns how many, more than {@link #MOST_NEAR} standing for any number. */
    private static int findNear(Tile tile, WideHierarchy hierarchy) {
        Leaves leaves = tile.leaves;
        SphereColumns spheres = hierarchy.spheres;
        int count = leaves.find(hierarchy, tile.beam, MOST_LEAVES) ? 0 : MOST_NEAR + 1;
        for (int k = leaves.first; k < leaves.end && count <= MOST_NEAR; k++) {
            int leaf = leaves.links[k];
            int first = WideHierarchy.firstBlock(leaf);
            for (int left = WideHierarchy.blocks(leaf); left > 0 && count <= MOST_NEAR; left--) {
                long met = tile.beam.meeting(spheres, first);
                tile.near.copy(SphereColumns.FIRST + count, spheres, first, met);
                count += Long.bitCount(met);
                first += spheres.step;
            }
        }
        return count;
    }

    private static void sample(Tile tile, Drawing drawing) {
        for (int k = 0; k < tile.shadows.count; k++) {
            int at = tile.shadows.places[k];
            if (ShadowCandidates.find(tile, at, drawing.bodies, tile.shadow)) {
                sample(tile, drawing, at);
            }
        }
    }

    /** Counts samples for a packet with lanes neither in the light nor in the dark. */
    private static void sample(Tile tile, Drawing drawing, int at) {
        ShadowFrame.findAxes(tile, at, drawing, tile.shadow);
        ShadowFrame.placeAll(tile, at, drawing.bodies, tile.shadow);
        ShadowFrame.limitAll(tile, at, drawing.bodies, tile.shadow);
        ShadowFrame.judgeAll(tile, at, drawing.bodies, tile.shadow);
        ShadowConics.prepare(tile.shadow);
        ShadowRange.choose(drawing, tile.shadow);
        ShadowRange.findPlaces(tile.values, at, tile.shadow);
        ShadowRange.find(drawing, tile.shadow);
        count(tile, drawing, at);
        finish(tile, drawing, at);
    }

    /** Writes how many samples are blocked. */
    static void count(Tile tile, Drawing drawing, int at) {
        ShadowScratch scratch = tile.shadow;
        if (!scratch.conical) {
            float[] disc = drawing.input.shadowDisc();
            ShadowRays.countAny(scratch, tile.values, at + Tile.LIGHT_DISTANCE, disc, drawing.shadowSamples);
        } else {
            ShadowConics.count(scratch);
        }
    }

    /** Writes the visible parts of the open lanes. */
    static void finish(Tile tile, Drawing drawing, int at) {
        float[] t = tile.values;
        FloatVector blocked = Lanes.load(tile.shadow.frame, ShadowScratch.BLOCKED);
        FloatVector visible = Lanes.all(1f).sub(blocked.div(drawing.shadowSamples));
        Lanes.load(t, at + Tile.VISIBLE)
                .blend(visible, Lanes.load(t, at + Tile.SHADOW_OPEN).compare(VectorOperators.GT, 0f))
                .intoArray(t, at + Tile.VISIBLE);
    }
}
