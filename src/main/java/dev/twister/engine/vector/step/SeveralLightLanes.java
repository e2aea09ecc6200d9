package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.ShadingLight;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** The light of all lights, summed up light by light: {@link dev.twister.kernel.SeveralLights}. */
public final class SeveralLightLanes {
    private SeveralLightLanes() {}

    /** Sets the sums to 0. */
    public static void start(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            Lanes.all(0f).intoArray(t, at + Tile.LIT);
            for (int channel = 0; channel < 3; channel++) {
                Lanes.all(0f).intoArray(t, at + channel * Tile.SIZE + Tile.HIGHLIGHT_RED);
            }
        }
    }

    /** Adds {@code k * max(0, N.L) * S} and the highlight of the light that shades. */
    public static void add(Tile tile, Drawing drawing) {
        ShadingLight light = drawing.lights[tile.light];
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            // max(0, x) is 0 for NaN, which lanes without a surface may hold.
            FloatVector part = Lanes.larger(Lanes.all(0f), Lanes.load(t, at + Tile.NORMAL_DOT_LIGHT))
                    .mul(light.share)
                    .mul(Lanes.load(t, at + Tile.VISIBLE));
            Lanes.load(t, at + Tile.LIT).add(part).intoArray(t, at + Tile.LIT);
            addHighlight(t, at, Tile.HIGHLIGHT_RED, light.red);
            addHighlight(t, at, Tile.HIGHLIGHT_GREEN, light.green);
            addHighlight(t, at, Tile.HIGHLIGHT_BLUE, light.blue);
        }
    }

    private static void addHighlight(float[] t, int at, int column, float color) {
        Lanes.load(t, at + column)
                .add(Lanes.load(t, at + Tile.SPECULAR).mul(color))
                .intoArray(t, at + column);
    }

    /**
     * Adds the highlights to the radiance, and writes the sum of {@link Tile#LIT} as the cosine of an unshaded light
     * without a highlight, for {@link ScatterLanes#shade}.
     *
     * @param tints whether the tints of {@link MetalLanes} are there
     */
    public static void finish(Tile tile, boolean tints) {
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector throughput = Lanes.all(0f)
                    .blend(
                            Lanes.load(t, at + Tile.THROUGHPUT),
                            Lanes.load(t, at + Tile.HIT).compare(VectorOperators.GE, Layout.PLANE));
            for (int channel = 0; channel < 3; channel++) {
                int column = at + channel * Tile.SIZE;
                FloatVector highlight = Lanes.larger(Lanes.all(0f), Lanes.load(t, column + Tile.HIGHLIGHT_RED))
                        .mul(throughput);
                if (tints) {
                    highlight = highlight.mul(Lanes.larger(Lanes.all(0f), Lanes.load(t, column + Tile.SHEEN_RED)));
                }
                Lanes.load(t, column + Tile.RED).add(highlight).intoArray(t, column + Tile.RED);
            }
            Lanes.load(t, at + Tile.LIT).intoArray(t, at + Tile.NORMAL_DOT_LIGHT);
            Lanes.all(1f).intoArray(t, at + Tile.VISIBLE);
            Lanes.all(0f).intoArray(t, at + Tile.SPECULAR);
        }
    }
}
