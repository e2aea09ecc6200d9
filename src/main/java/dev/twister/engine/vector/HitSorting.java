package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Sorts packets by what their lanes met; a packet may be in several lists. */
final class HitSorting {
    private HitSorting() {}

    /** Fills the lists of skies, grounds, spheres and surfaces, and adds the light's colour where it is met. */
    static void sort(Tile tile, BodyColumns bodies) {
        tile.skies.clear();
        tile.grounds.clear();
        tile.spheres.clear();
        tile.surfaces.clear();
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            VectorMask<Float> ended = Lanes.load(t, at + Tile.THROUGHPUT).compare(VectorOperators.LE, 0f);
            FloatVector hit = Lanes.load(t, at + Tile.HIT).blend(Tile.ENDED, ended);
            hit.intoArray(t, at + Tile.HIT);
            if (hit.compare(VectorOperators.EQ, Layout.NOTHING).anyTrue()) {
                tile.skies.add(at);
            }
            if (hit.compare(VectorOperators.EQ, Layout.LIGHT).anyTrue()) {
                addLight(t, at, bodies);
            }
            boolean ground = hit.compare(VectorOperators.EQ, Layout.PLANE).anyTrue();
            boolean sphere = hit.compare(VectorOperators.GT, Layout.PLANE).anyTrue();
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

    private static void addLight(float[] t, int at, BodyColumns bodies) {
        FloatVector throughput = Lanes.all(0f)
                .blend(
                        Lanes.load(t, at + Tile.THROUGHPUT),
                        Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.LIGHT));
        add(t, at + Tile.RED, throughput, bodies.red[Layout.LIGHT]);
        add(t, at + Tile.GREEN, throughput, bodies.green[Layout.LIGHT]);
        add(t, at + Tile.BLUE, throughput, bodies.blue[Layout.LIGHT]);
    }

    private static void add(float[] t, int at, FloatVector throughput, float radiance) {
        throughput.fma(Lanes.all(radiance), Lanes.load(t, at)).intoArray(t, at);
    }
}
