package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.ShadingLight;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** What metals do to the light that they reflect: the tint of {@link dev.twister.kernel.Scatter}. */
public final class MetalLanes {
    private MetalLanes() {}

    /** Writes the tints, 1 where the surface is not metallic, and lists the packets with metals. */
    public static void find(Tile tile) {
        float[] t = tile.values;
        tile.metals.clear();
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector stored = Lanes.load(t, at + Tile.METALLIC);
            FloatVector metallic = stored.blend(Lanes.all(-1f).sub(stored), stored.compare(VectorOperators.LT, 0f));
            for (int channel = 0; channel < 3; channel++) {
                int column = at + channel * Tile.SIZE;
                Lanes.all(1f)
                        .add(metallic.mul(
                                Lanes.load(t, column + Tile.ALBEDO_RED).sub(1f)))
                        .intoArray(t, column + Tile.SHEEN_RED);
            }
            if (metallic.compare(VectorOperators.GT, 0f).anyTrue()) {
                tile.metals.add(at);
            }
        }
    }

    /**
     * Adds {@code T * lightColor * spec * (tint - 1)} in packets with metals, whose shading adds the highlight without
     * the tint.
     */
    public static void tintHighlights(Tile tile, Drawing drawing) {
        ShadingLight light = drawing.lights[tile.light];
        tintHighlights(tile, 0, light.red);
        tintHighlights(tile, Tile.SIZE, light.green);
        tintHighlights(tile, 2 * Tile.SIZE, light.blue);
    }

    private static void tintHighlights(Tile tile, int column, float light) {
        float[] t = tile.values;
        for (int k = 0; k < tile.metals.count; k++) {
            int at = tile.metals.places[k];
            FloatVector tint = Lanes.load(t, at + column + Tile.SHEEN_RED).sub(1f);
            FloatVector highlight = Lanes.load(t, at + Tile.THROUGHPUT)
                    .mul(Lanes.load(t, at + Tile.SPECULAR))
                    .mul(light);
            FloatVector before = Lanes.load(t, at + column + Tile.RED);
            before.blend(
                            before.add(highlight.mul(tint)),
                            Lanes.load(t, at + Tile.HIT).compare(VectorOperators.GE, Layout.PLANE))
                    .intoArray(t, at + column + Tile.RED);
        }
    }
}
