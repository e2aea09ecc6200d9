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
            FloatVector metallic = Lanes.load(t, at + Tile.METALLIC);
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
     * Adds {@code T * tint * lightColor * spec} in packets with metals, and sets the specular column to 0, so that
     * shading does not add the highlight without the tint.
     */
    public static void addHighlights(Tile tile, Drawing drawing) {
        ShadingLight light = drawing.lights[tile.light];
        float[] t = tile.values;
        for (int k = 0; k < tile.metals.count; k++) {
            int at = tile.metals.places[k];
            addHighlight(t, at, 0, light.red);
            addHighlight(t, at, Tile.SIZE, light.green);
            addHighlight(t, at, 2 * Tile.SIZE, light.blue);
            Lanes.all(0f).intoArray(t, at + Tile.SPECULAR);
        }
    }

    private static void addHighlight(float[] t, int at, int column, float color) {
        FloatVector highlight = Lanes.load(t, at + Tile.THROUGHPUT)
                .mul(Lanes.load(t, at + Tile.SPECULAR))
                .mul(color)
                .mul(Lanes.load(t, at + column + Tile.SHEEN_RED));
        FloatVector before = Lanes.load(t, at + column + Tile.RED);
        before.blend(before.add(highlight), Lanes.load(t, at + Tile.HIT).compare(VectorOperators.GE, Layout.PLANE))
                .intoArray(t, at + column + Tile.RED);
    }
}
