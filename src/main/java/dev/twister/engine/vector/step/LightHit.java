package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.ShadingLight;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** Hits of lights: their own color, unshaded. */
public final class LightHit {
    private LightHit() {}

    /**
     * Adds the lights' colors. Rays that hit a light after the first are ended, as the numbers of these lights are
     * among those of surfaces.
     */
    public static void add(Tile tile, Drawing drawing) {
        addFirst(tile, drawing.lights[0]);
        if (drawing.lightSpheres) {
            endAtSpheres(tile, drawing);
        }
    }

    private static void addFirst(Tile tile, ShadingLight light) {
        float[] t = tile.values;
        for (int k = 0; k < tile.lights.count; k++) {
            int at = tile.lights.places[k];
            FloatVector throughput = Lanes.all(0f)
                    .blend(
                            Lanes.load(t, at + Tile.THROUGHPUT),
                            Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.LIGHT));
            Lanes.fma(throughput, Lanes.all(light.red), Lanes.load(t, at + Tile.RED))
                    .intoArray(t, at + Tile.RED);
            Lanes.fma(throughput, Lanes.all(light.green), Lanes.load(t, at + Tile.GREEN))
                    .intoArray(t, at + Tile.GREEN);
            Lanes.fma(throughput, Lanes.all(light.blue), Lanes.load(t, at + Tile.BLUE))
                    .intoArray(t, at + Tile.BLUE);
        }
    }

    private static void endAtSpheres(Tile tile, Drawing drawing) {
        float[] t = tile.values;
        float[] looks = drawing.input.bodies().looks();
        for (int k = 0; k < tile.lights.count; k++) {
            int at = tile.lights.places[k];
            for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
                int hit = (int) t[pixel + Tile.HIT];
                if (hit > Layout.LIGHT && drawing.input.isLight(hit)) {
                    int look = Layout.LOOK_STRIDE * hit;
                    float throughput = t[pixel + Tile.THROUGHPUT];
                    t[pixel + Tile.RED] += throughput * looks[look];
                    t[pixel + Tile.GREEN] += throughput * looks[look + 1];
                    t[pixel + Tile.BLUE] += throughput * looks[look + 2];
                    t[pixel + Tile.THROUGHPUT] = 0f;
                    t[pixel + Tile.HIT] = Tile.ENDED;
                }
            }
        }
    }
}
