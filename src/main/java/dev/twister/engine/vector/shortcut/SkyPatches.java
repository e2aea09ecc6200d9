package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.PaddedSky;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.PatchList;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Radiance of the panorama where all lanes of a packet see a few adjacent texels, as view rays do. Each texel is read
 * once and weighted in all lanes; the bilinear weights of more distant texels are 0.
 */
public final class SkyPatches {
    /** With more texels, per-lane lookup is faster; see {@code docs/decisions/018}. */
    private static final int MOST_TEXELS = 2 * Lanes.COUNT;

    private SkyPatches() {}

    /** Separates the packets that see a patch from the scattered ones. */
    static void sort(Tile tile) {
        float[] t = tile.values;
        PatchList patches = tile.skyPatches;
        patches.clear();
        tile.scatteredSkies.clear();
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            VectorMask<Integer> met = Lanes.load(t, at + Tile.HIT)
                    .compare(VectorOperators.EQ, Layout.NOTHING)
                    .cast(Lanes.INTS);
            IntVector column = Lanes.truncated(Lanes.load(t, at + Tile.SKY_TO_RIGHT));
            IntVector row = Lanes.truncated(Lanes.load(t, at + Tile.SKY_TO_BOTTOM));
            int left = column.reduceLanes(VectorOperators.MIN, met);
            int top = row.reduceLanes(VectorOperators.MIN, met);
            int columns = column.reduceLanes(VectorOperators.MAX, met) - left + 2;
            int rows = row.reduceLanes(VectorOperators.MAX, met) - top + 2;
            if (columns * rows <= MOST_TEXELS) {
                patches.places[patches.count] = at;
                patches.left[patches.count] = left;
                patches.top[patches.count] = top;
                patches.columns[patches.count] = columns;
                patches.rows[patches.count] = rows;
                patches.count++;
            } else {
                tile.scatteredSkies.add(at);
            }
        }
    }

    /** Adds the patches' radiance to the lanes that hit nothing. */
    static void add(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        PatchList patches = tile.skyPatches;
        for (int k = 0; k < patches.count; k++) {
            int at = patches.places[k];
            FloatVector toRight = Lanes.load(t, at + Tile.SKY_TO_RIGHT).sub(patches.left[k]);
            FloatVector toBottom = Lanes.load(t, at + Tile.SKY_TO_BOTTOM).sub(patches.top[k]);
            FloatVector red = Lanes.all(0f);
            FloatVector green = Lanes.all(0f);
            FloatVector blue = Lanes.all(0f);
            for (int row = 0; row < patches.rows[k]; row++) {
                // Weight along one side: 1 at the texel's center, 0 from the next texel's center on.
                FloatVector high =
                        Lanes.larger(Lanes.all(1f).sub(toBottom.sub(row).abs()), Lanes.all(0f));
                int texel = PaddedSky.NUMBERS_A_TEXEL * ((patches.top[k] + row) * sky.stride() + patches.left[k]);
                for (int column = 0; column < patches.columns[k]; column++) {
                    FloatVector wide =
                            Lanes.larger(Lanes.all(1f).sub(toRight.sub(column).abs()), Lanes.all(0f));
                    FloatVector weight = high.mul(wide);
                    red = Lanes.fma(weight, Lanes.all(sky.value(texel)), red);
                    green = Lanes.fma(weight, Lanes.all(sky.value(texel + 1)), green);
                    blue = Lanes.fma(weight, Lanes.all(sky.value(texel + 2)), blue);
                    texel += PaddedSky.NUMBERS_A_TEXEL;
                }
            }
            VectorMask<Float> met = Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.NOTHING);
            FloatVector throughput =
                    Lanes.all(0f).blend(Lanes.load(t, at + Tile.THROUGHPUT).mul(sky.strength), met);
            Lanes.fma(throughput, red, Lanes.load(t, at + Tile.RED)).intoArray(t, at + Tile.RED);
            Lanes.fma(throughput, green, Lanes.load(t, at + Tile.GREEN)).intoArray(t, at + Tile.GREEN);
            Lanes.fma(throughput, blue, Lanes.load(t, at + Tile.BLUE)).intoArray(t, at + Tile.BLUE);
        }
    }
}
