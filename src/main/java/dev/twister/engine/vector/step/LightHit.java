package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** Hits of the light: its own color, unshaded. */
public final class LightHit {
    private LightHit() {}

    public static void add(Tile tile, BodyColumns bodies) {
        float red = bodies.red(Layout.LIGHT);
        float green = bodies.green(Layout.LIGHT);
        float blue = bodies.blue(Layout.LIGHT);
        float[] t = tile.values;
        for (int k = 0; k < tile.lights.count; k++) {
            int at = tile.lights.places[k];
            FloatVector throughput = Lanes.all(0f)
                    .blend(
                            Lanes.load(t, at + Tile.THROUGHPUT),
                            Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.LIGHT));
            Lanes.fma(throughput, Lanes.all(red), Lanes.load(t, at + Tile.RED)).intoArray(t, at + Tile.RED);
            Lanes.fma(throughput, Lanes.all(green), Lanes.load(t, at + Tile.GREEN))
                    .intoArray(t, at + Tile.GREEN);
            Lanes.fma(throughput, Lanes.all(blue), Lanes.load(t, at + Tile.BLUE))
                    .intoArray(t, at + Tile.BLUE);
        }
    }
}
