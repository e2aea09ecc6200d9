package dev.twister.engine.vector;

/**
 * The visible part of the light where the points of a packet have little in common, point by point: lanes hold boxes and
 * spheres on the way to the candidates, and samples at its end.
 */
final class LoneShadows {
    private LoneShadows() {}

    /** Writes the visible parts at the packet's open points, out of the spheres that are near any of them. */
    static void findAmong(SphereColumns near, Tile tile, int at, Drawing drawing) {
        float[] t = tile.values;
        LoneCandidates candidates = tile.shadow.lone;
        for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
            if (t[pixel + Tile.SHADOW_OPEN] > 0f) {
                candidates.start(t, pixel, drawing.discRadius);
                boolean dark = candidates.add(near, 0, near.count);
                t[pixel + Tile.VISIBLE] = dark ? 0f : visible(candidates, drawing);
            }
        }
    }

    /** The same by way of the whole hierarchy. */
    static void find(Tile tile, int at, Drawing drawing) {
        float[] t = tile.values;
        LoneCandidates candidates = tile.shadow.lone;
        for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
            if (t[pixel + Tile.SHADOW_OPEN] > 0f) {
                candidates.start(t, pixel, drawing.discRadius);
                boolean dark = walk(tile, pixel, drawing.hierarchy, candidates);
                t[pixel + Tile.VISIBLE] = dark ? 0f : visible(candidates, drawing);
            }
        }
    }

    private static float visible(LoneCandidates candidates, Drawing drawing) {
        return candidates.visible(drawing.discX, drawing.discY, drawing.shadowSamples);
    }

    /** Lists the candidates; returns whether one of them hides the whole disc. */
    private static boolean walk(Tile tile, int pixel, WideHierarchy hierarchy, LoneCandidates candidates) {
        Beam beam = tile.beam;
        beam.holdLines(tile.values, pixel);
        boolean dark = false;
        if (tile.leaves.find(hierarchy, beam, Leaves.MOST)) {
            for (int k = 0; k < tile.leaves.count && !dark; k++) {
                dark = add(hierarchy, tile.leaves.places[k], candidates);
            }
        } else {
            Descent descent = tile.descent;
            descent.start(hierarchy, beam);
            int leaf = descent.nextLeaf(hierarchy, beam);
            while (leaf >= 0) {
                dark = add(hierarchy, leaf, candidates);
                leaf = dark ? -1 : descent.nextLeaf(hierarchy, beam);
            }
        }
        return dark;
    }

    private static boolean add(WideHierarchy hierarchy, int leaf, LoneCandidates candidates) {
        int first = hierarchy.links[leaf];
        return candidates.add(hierarchy.spheres, first, first + hierarchy.counts[leaf]);
    }
}
