package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** The visible part of the light at the points of a tile. */
final class Shadows {
    private final Hull hull = new Hull();
    private final BodyList tileCandidates = new BodyList();
    private final BodyList packetCandidates = new BodyList();
    private final ShadowScratch scratch = new ShadowScratch();

    void reserve(int bodies) {
        tileCandidates.reserve(bodies);
        packetCandidates.reserve(bodies);
    }

    void find(Tile tile, Drawing drawing) {
        if (tile.shadows.count > 0) {
            BodyColumns bodies = drawing.bodies;
            hull.startAround(tile, tile.shadows, Tile.POINT_X, Tile.SHADOW_OPEN);
            hull.endIn(bodies.x[Layout.LIGHT], bodies.y[Layout.LIGHT], bodies.z[Layout.LIGHT], drawing.discRadius);
            hull.cull(bodies, Layout.FIRST_SPHERE, tileCandidates);
            if (tileCandidates.count > 0) {
                sample(tile, drawing);
            }
        }
    }

    private void sample(Tile tile, Drawing drawing) {
        ShadowCandidates.findDiscs(tile, drawing);
        for (int k = 0; k < tile.shadows.count; k++) {
            int at = tile.shadows.places[k];
            if (ShadowCandidates.find(tile, at, drawing.bodies, tileCandidates, packetCandidates)) {
                ShadowFrame.findAxes(tile, at, drawing, scratch);
                boolean between = ShadowFrame.placeAll(tile, at, drawing.bodies, packetCandidates, scratch);
                if (between) {
                    ShadowConics.prepare(scratch, packetCandidates.count);
                }
                count(tile, at, drawing, between);
            }
        }
    }

    /** Writes the visible parts of the open lanes. */
    private void count(Tile tile, int at, Drawing drawing, boolean between) {
        float[] t = tile.values;
        float[] disc = drawing.input.shadowDisc();
        int samples = drawing.shadowSamples;
        int count = packetCandidates.count;
        if (!between) {
            ShadowRays.countAny(scratch, count, t, at + Tile.LIGHT_DISTANCE, disc, samples);
        } else if (count == 1) {
            ShadowConics.countOne(scratch, disc, samples);
        } else {
            ShadowConics.countAny(scratch, count, disc, samples);
        }
        FloatVector blocked = Lanes.load(scratch.frame, ShadowScratch.BLOCKED);
        FloatVector visible = Lanes.all(1f).sub(blocked.div(samples));
        Lanes.load(t, at + Tile.VISIBLE)
                .blend(visible, Lanes.load(t, at + Tile.SHADOW_OPEN).compare(VectorOperators.GT, 0f))
                .intoArray(t, at + Tile.VISIBLE);
    }
}
