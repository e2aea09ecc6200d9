package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.ShortVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The panorama's radiance, bilinear between four texels, where the lanes of a packet look here and there. Its vectors are of
 * other widths than the packets', for which {@link Lanes#fma} is kept, so that the compiler knows their width there.
 */
final class SkyRadiance {
    /** A texel: red, green, blue and a blank. */
    private static final VectorSpecies<Float> TEXEL = FloatVector.SPECIES_128;

    /** Two texels side by side: red, green, blue, red, green, blue and two blanks. */
    private static final VectorSpecies<Float> PAIR = FloatVector.SPECIES_256;

    private static final VectorSpecies<Integer> PAIR_BITS = IntVector.SPECIES_256;
    private static final VectorSpecies<Short> HALVED_PAIR = ShortVector.SPECIES_128;

    private SkyRadiance() {}

    /** Lists the pixels that met nothing. */
    static void listPixels(Tile tile) {
        float[] t = tile.values;
        int count = 0;
        for (int k = 0; k < tile.scatteredSkies.count; k++) {
            int at = tile.scatteredSkies.places[k];
            long met = Lanes.load(t, at + Tile.HIT)
                    .compare(VectorOperators.EQ, Layout.NOTHING)
                    .toLong();
            Lanes.pack(tile.pixels, at, met, tile.lonely, count);
            count += Long.bitCount(met);
        }
        tile.lonelyCount = count;
    }

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

    /** Looks the sky up for every listed pixel, one a step. */
    static void blend(Tile tile, PaddedSky sky) {
        if (sky.halved) {
            blendHalves(tile, sky);
        } else {
            blendFloats(tile, sky);
        }
    }

    /**
     * The pixel's four texels are two vectors, with no gather. Without helpers, for the reason that {@link ShadowConics} has.
     */
    private static void blendHalves(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        short[] halves = sky.halves;
        float[] pair = tile.skyColor;
        int below = PaddedSky.NUMBERS_A_TEXEL * sky.stride();
        for (int k = 0; k < tile.lonelyCount; k++) {
            int pixel = tile.lonely[k];
            int texel = PaddedSky.NUMBERS_A_TEXEL * tile.texels[pixel];
            FloatVector upper = ((IntVector) ShortVector.fromArray(HALVED_PAIR, halves, texel)
                            .convertShape(VectorOperators.ZERO_EXTEND_S2I, PAIR_BITS, 0))
                    .lanewise(VectorOperators.LSHL, PaddedSky.LOWER_BITS)
                    .reinterpretAsFloats();
            FloatVector lower = ((IntVector) ShortVector.fromArray(HALVED_PAIR, halves, texel + below)
                            .convertShape(VectorOperators.ZERO_EXTEND_S2I, PAIR_BITS, 0))
                    .lanewise(VectorOperators.LSHL, PaddedSky.LOWER_BITS)
                    .reinterpretAsFloats();
            FloatVector toBottom = FloatVector.broadcast(PAIR, t[pixel + Tile.SKY_TO_BOTTOM]);
            lower.sub(upper).mul(toBottom).add(upper).intoArray(pair, 0);
            float toRight = t[pixel + Tile.SKY_TO_RIGHT];
            t[pixel + Tile.SKY_RED] = pair[0] + (pair[3] - pair[0]) * toRight;
            t[pixel + Tile.SKY_GREEN] = pair[1] + (pair[4] - pair[1]) * toRight;
            t[pixel + Tile.SKY_BLUE] = pair[2] + (pair[5] - pair[2]) * toRight;
        }
    }

    /** The same with four vectors. */
    private static void blendFloats(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        float[] floats = sky.floats;
        float[] color = tile.skyColor;
        int right = PaddedSky.NUMBERS_A_TEXEL;
        int below = right * sky.stride();
        for (int k = 0; k < tile.lonelyCount; k++) {
            int pixel = tile.lonely[k];
            int texel = right * tile.texels[pixel];
            FloatVector toRight = FloatVector.broadcast(TEXEL, t[pixel + Tile.SKY_TO_RIGHT]);
            FloatVector upper = FloatVector.fromArray(TEXEL, floats, texel);
            FloatVector lower = FloatVector.fromArray(TEXEL, floats, texel + below);
            upper = FloatVector.fromArray(TEXEL, floats, texel + right)
                    .sub(upper)
                    .mul(toRight)
                    .add(upper);
            lower = FloatVector.fromArray(TEXEL, floats, texel + below + right)
                    .sub(lower)
                    .mul(toRight)
                    .add(lower);
            FloatVector toBottom = FloatVector.broadcast(TEXEL, t[pixel + Tile.SKY_TO_BOTTOM]);
            lower.sub(upper).mul(toBottom).add(upper).intoArray(color, 0);
            t[pixel + Tile.SKY_RED] = color[0];
            t[pixel + Tile.SKY_GREEN] = color[1];
            t[pixel + Tile.SKY_BLUE] = color[2];
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
                Lanes.fma(throughput, radiance, before).intoArray(t, channel + Tile.RED);
            }
        }
    }
}
