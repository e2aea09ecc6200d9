package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.crowd.Beam;
import dev.twister.engine.vector.crowd.BeamStack;
import dev.twister.engine.vector.crowd.PacketLeaves;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Shortcut;
import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;

/**
 * The visible part of the light, point by point, for packets whose points are not coherent. Lanes hold boxes and
 * spheres while candidates are collected, then samples.
 */
public final class PointShadows {
    private PointShadows() {}

    /** Writes the visible part at each open point of a packet, given the spheres near any of them. */
    static void findAmong(SphereColumns near, int count, Tile tile, int at, Drawing drawing, ShadowMemory bench) {
        float[] t = tile.values;
        PointCandidates candidates = bench.lone;
        for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
            if (t[pixel + Tile.SHADOW_OPEN] > 0f) {
                candidates.start(t, pixel, drawing.lights[tile.light].discRadius);
                boolean dark = candidates.add(near, SphereColumns.FIRST, count);
                t[pixel + Tile.VISIBLE] = dark ? 0f : visible(candidates, drawing);
            }
        }
    }

    /** As above for the points of {@link Tile#lonely}, through the hierarchy. */
    static void find(Drawing drawing, Tile tile, ShadowMemory bench) {
        for (int first = 0; first < tile.lonely.count; first += Lanes.COUNT) {
            find(drawing, tile, bench, first, Math.min(Lanes.COUNT, tile.lonely.count - first));
        }
    }

    private static void find(Drawing drawing, Tile tile, ShadowMemory bench, int first, int count) {
        float[] t = tile.values;
        int[] pixels = tile.lonely.pixels;
        PointCandidates candidates = bench.lone;
        PacketLeaves leaves = bench.walks.packetLeaves;
        bench.walks.packetBeams.holdLines(t, pixels, first);
        boolean found = leaves.find(drawing.hierarchy, bench.walks.packetBeams, count);
        long shaded = Lanes.first(count);
        if (found) {
            bench.leafCandidates.find(drawing.hierarchy, bench.walks.packetBeams, leaves);
            shaded = bench.leafCandidates.shaded;
            for (int beam = 0; beam < count; beam++) {
                t[pixels[first + beam] + Tile.VISIBLE] = 1f;
            }
        }
        for (long rest = shaded; rest != 0L; rest &= rest - 1) {
            int beam = Long.numberOfTrailingZeros(rest);
            int pixel = pixels[first + beam];
            candidates.start(t, pixel, drawing.lights[tile.light].discRadius);
            boolean dark = found
                    ? addLeaves(bench, beam, drawing.hierarchy, candidates)
                    : descend(bench, tile, pixel, drawing.hierarchy, candidates);
            t[pixel + Tile.VISIBLE] = dark ? 0f : visible(candidates, drawing);
        }
    }

    private static float visible(PointCandidates candidates, Drawing drawing) {
        return candidates.visible(
                drawing.discX, drawing.discY, drawing.shadowSamples, drawing.shortcuts.take(Shortcut.CONICS));
    }

    /** Collects the candidates from the leaves found; returns whether one of them blocks the whole disc. */
    private static boolean addLeaves(
            ShadowMemory bench, int beam, WideHierarchy hierarchy, PointCandidates candidates) {
        LeafCandidates leaves = bench.leafCandidates;
        boolean dark = false;
        for (int k = 0; k < leaves.count && !dark; k++) {
            int link = leaves.links[k];
            dark = link >>> WideHierarchy.BEAM_SHIFT == beam && candidates.add(hierarchy, link);
        }
        return dark;
    }

    /** As above, from the whole hierarchy, nearest leaf first. */
    private static boolean descend(
            ShadowMemory bench, Tile tile, int pixel, WideHierarchy hierarchy, PointCandidates candidates) {
        Beam beam = bench.walks.beam;
        BeamStack descent = bench.walks.descent;
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
