package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Sorts packets by what their lanes hit; a packet may be in several lists. */
public final class HitSorting {
    private HitSorting() {}

    /** Fills the lists if no ray of the tile can hit anything. */
    public static void sortSkies(Tile tile) {
        clear(tile);
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            VectorMask<Float> ended = Lanes.load(t, at + Tile.THROUGHPUT).compare(VectorOperators.LE, 0f);
            Lanes.all(Layout.NOTHING).blend(Tile.ENDED, ended).intoArray(t, at + Tile.HIT);
            tile.skies.add(at);
        }
    }

    private static void clear(Tile tile) {
        tile.skies.clear();
        tile.lights.clear();
        tile.grounds.clear();
        tile.spheres.clear();
        tile.surfaces.clear();
    }

    /** Fills the lists of skies, lights, grounds, spheres and surfaces. */
    public static void sort(Tile tile, Drawing drawing) {
        clear(tile);
        int firstLight = drawing.input.bodies().room();
        int endOfLights = drawing.input.bodies().sphereEnd();
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            VectorMask<Float> ended = Lanes.load(t, at + Tile.THROUGHPUT).compare(VectorOperators.LE, 0f);
            FloatVector hit = Lanes.load(t, at + Tile.HIT).blend(Tile.ENDED, ended);
            hit.intoArray(t, at + Tile.HIT);
            if (hit.compare(VectorOperators.EQ, Layout.NOTHING).anyTrue()) {
                tile.skies.add(at);
            }
            VectorMask<Float> light = hit.compare(VectorOperators.EQ, Layout.LIGHT);
            if (drawing.lightSpheres) {
                light = light.or(
                        hit.compare(VectorOperators.GE, firstLight).and(hit.compare(VectorOperators.LT, endOfLights)));
            }
            if (light.anyTrue()) {
                tile.lights.add(at);
            }
            boolean ground = hit.compare(VectorOperators.EQ, Layout.PLANE).anyTrue();
            boolean sphere =
                    hit.compare(VectorOperators.GT, Layout.PLANE).andNot(light).anyTrue();
            if (ground) {
                tile.grounds.add(at);
            }
            if (sphere) {
                tile.spheres.add(at);
            }
            if (ground || sphere) {
                tile.surfaces.add(at);
            }
        }
    }
}
