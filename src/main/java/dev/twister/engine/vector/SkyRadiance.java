package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/** The panorama's radiance, bilinear between four texels, where the lanes of a packet look here and there. */
final class SkyRadiance {
    /** A texel: red, green, blue and a blank. */
    private static final VectorSpecies<Float> TEXEL = FloatVector.SPECIES_128;

    private SkyRadiance() {}

    /** Turns columns and rows into the upper left texels and the fractions from them. */
    static void findTexels(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        for (int k = 0; k < tile.scatteredSkies.count; k++) {
            int at = tile.scatteredSkies.places[k];
            FloatVector column = Lanes.load(t, at + Tile.SKY_TO_RIGHT);
            FloatVector row = Lanes.load(t, at + Tile.SKY_TO_BOTTOM);
            IntVector left = Lanes.truncated(column);
            IntVector top = Lanes.truncated(row);
            column.sub(Lanes.toFloats(left)).intoArray(t, at + Tile.SKY_TO_RIGHT);
            row.sub(Lanes.toFloats(top)).intoArray(t, at + Tile.SKY_TO_BOTTOM);
            top.mul(sky.stride()).add(left).intoArray(tile.texels, at);
        }
    }

    /**
     * Looks the sky up for every lane, one pixel a step: its four texels are four vectors, with no gather. Without helpers,
     * for the reason that {@link ShadowConics} has.
     */
    static void blend(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        float[] texels = sky.texels;
        int below = PaddedSky.FLOATS_A_TEXEL * sky.stride();
        for (int k = 0; k < tile.scatteredSkies.count; k++) {
            int first = tile.scatteredSkies.places[k];
            for (int pixel = first; pixel < first + Lanes.COUNT; pixel++) {
                int texel = PaddedSky.FLOATS_A_TEXEL * tile.texels[pixel];
                FloatVector toRight = FloatVector.broadcast(TEXEL, t[pixel + Tile.SKY_TO_RIGHT]);
                FloatVector upper = FloatVector.fromArray(TEXEL, texels, texel);
                FloatVector lower = FloatVector.fromArray(TEXEL, texels, texel + below);
                upper = FloatVector.fromArray(TEXEL, texels, texel + PaddedSky.FLOATS_A_TEXEL)
                        .sub(upper)
                        .fma(toRight, upper);
                lower = FloatVector.fromArray(TEXEL, texels, texel + below + PaddedSky.FLOATS_A_TEXEL)
                        .sub(lower)
                        .fma(toRight, lower);
                FloatVector toBottom = FloatVector.broadcast(TEXEL, t[pixel + Tile.SKY_TO_BOTTOM]);
                lower.sub(upper).fma(toBottom, upper).intoArray(tile.skyColor, 0);
                t[pixel + Tile.SKY_RED] = tile.skyColor[0];
                t[pixel + Tile.SKY_GREEN] = tile.skyColor[1];
                t[pixel + Tile.SKY_BLUE] = tile.skyColor[2];
            }
        }
    }

    /** Adds what {@link #blend} found to the lanes that met nothing. */
    static void add(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.scatteredSkies.count; k++) {
            int at = tile.scatteredSkies.places[k];
            VectorMask<Float> met =
                    FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.NOTHING);
            FloatVector throughput = FloatVector.zero(Lanes.FLOATS)
                    .blend(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.THROUGHPUT), met);
            for (int channel = at; channel < at + 3 * Tile.SIZE; channel += Tile.SIZE) {
                FloatVector radiance = FloatVector.fromArray(Lanes.FLOATS, t, channel + Tile.SKY_RED);
                FloatVector before = FloatVector.fromArray(Lanes.FLOATS, t, channel + Tile.RED);
                throughput.fma(radiance, before).intoArray(t, channel + Tile.RED);
            }
        }
    }
}
