package dev.twister.engine.vector;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/**
 * The visible part of the light where the points of a packet have little in common, point by point: lanes hold boxes and
 * spheres on the way to the candidates, and samples at its end.
 */
final class LoneShadows {
    private LoneShadows() {}

    /** Writes the visible parts at the packet's open points, out of the spheres that are near any of them. */
    static void findAmong(SphereColumns near, int count, Tile tile, int at, Drawing drawing) {
        float[] t = tile.values;
        LoneCandidates candidates = tile.shadow.lone;
        for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
            if (t[pixel + Tile.SHADOW_OPEN] > 0f) {
                candidates.start(t, pixel, drawing.discRadius);
                boolean dark = candidates.add(near, SphereColumns.FIRST, count);
                t[pixel + Tile.VISIBLE] = dark ? 0f : visible(candidates, drawing);
            }
        }
    }

    /** The same by way of the whole hierarchy. */
    static void find(Tile tile, int at, Drawing drawing) {
        float[] t = tile.values;
        LoneCandidates candidates = tile.shadow.lone;
        PacketLeaves leaves = tile.packetLeaves;
        tile.packetBeams.holdLines(t, at);
        long open = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SHADOW_OPEN)
                .compare(VectorOperators.GT, 0f)
                .toLong();
        boolean found = leaves.find(drawing.hierarchy, tile.packetBeams, open);
        int from = leaves.first;
        for (long rest = open; rest != 0L; rest &= rest - 1) {
            int lane = Long.numberOfTrailingZeros(rest);
            int end = leaves.end(from, lane);
            if (found && from == end) {
                t[at + lane + Tile.VISIBLE] = 1f;
            } else {
                candidates.start(t, at + lane, drawing.discRadius);
                boolean dark = found
                        ? addLeaves(leaves, from, end, drawing.hierarchy, candidates)
                        : descend(tile, at + lane, drawing.hierarchy, candidates);
                t[at + lane + Tile.VISIBLE] = dark ? 0f : visible(candidates, drawing);
            }
            from = end;
        }
    }

    private static float visible(LoneCandidates candidates, Drawing drawing) {
        return candidates.visible(drawing.discX, drawing.discY, drawing.shadowSamples);
    }

    /** Lists the candidates out of the leaves found; returns whether one of them hides the whole disc. */
    private static boolean addLeaves(
            PacketLeaves leaves, int from, int end, WideHierarchy hierarchy, LoneCandidates candidates) {
        boolean dark = false;
        for (int k = from; k < end && !dark; k++) {
            dark = candidates.add(hierarchy, leaves.links[k]);
        }
        return dark;
    }

    /** The same out of the whole hierarchy, from the nearest leaf on. */
    private static boolean descend(Tile tile, int pixel, WideHierarchy hierarchy, LoneCandidates candidates) {
        Beam beam = tile.beam;
        Descent descent = tile.descent;
        beam.holdLines(tile.values, pixel);
        descent.start(hierarchy, beam);
        boolean dark = false;
        int leaf = descent.nextLeaf(hierarchy, beam);
        while (leaf >= 0) {
            dark = candidates.add(hierarchy, leaf);
            leaf = dark ? -1 : descent.nextLeaf(hierarchy, beam);
        }
        return dark;
    }
}
