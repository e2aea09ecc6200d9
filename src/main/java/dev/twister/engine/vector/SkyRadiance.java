package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/** The panorama's radiance, bilinear between four texels. */
final class SkyRadiance {
    /** A texel: red, green, blue and a blank. */
    private static final VectorSpecies<Float> TEXEL = FloatVector.SPECIES_128;

    /** From one pixel's colour to the next's. */
    private static final int[] PIXELS = VectorSteps.of(PaddedSky.FLOATS_A_TEXEL);

    private SkyRadiance() {}

    /** Looks the sky up for every lane, one pixel a step: its four texels are four vectors, with no gather. */
    static void blend(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        float[] texels = sky.texels;
        int below = PaddedSky.FLOATS_A_TEXEL * sky.stride();
        for (int k = 0; k < tile.skies.count; k++) {
            int first = tile.skies.places[k];
            for (int pixel = first; pixel < first + Lanes.COUNT; pixel++) {
                int texel = PaddedSky.FLOATS_A_TEXEL * tile.texels[pixel];
                FloatVector toRight = FloatVector.broadcast(TEXEL, t[pixel + Tile.SKY_TO_RIGHT]);
                FloatVector upper = between(texels, texel, toRight);
                FloatVector lower = between(texels, texel + below, toRight);
                FloatVector toBottom = FloatVector.broadcast(TEXEL, t[pixel + Tile.SKY_TO_BOTTOM]);
                lower.sub(upper).fma(toBottom, upper).intoArray(tile.skyColors, PaddedSky.FLOATS_A_TEXEL * pixel);
            }
        }
    }

    private static FloatVector between(float[] texels, int left, FloatVector toRight) {
        FloatVector leftTexel = FloatVector.fromArray(TEXEL, texels, left);
        FloatVector rightTexel = FloatVector.fromArray(TEXEL, texels, left + PaddedSky.FLOATS_A_TEXEL);
        return rightTexel.sub(leftTexel).fma(toRight, leftTexel);
    }

    /** Adds what {@link #blend} found to the lanes that met nothing. */
    static void add(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            FloatVector throughput = Lanes.all(0f)
                    .blend(
                            Lanes.load(t, at + Tile.THROUGHPUT),
                            Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.NOTHING));
            addChannel(tile, at, throughput, Tile.RED, 0);
            addChannel(tile, at, throughput, Tile.GREEN, 1);
            addChannel(tile, at, throughput, Tile.BLUE, 2);
        }
    }

    private static void addChannel(Tile tile, int at, FloatVector throughput, int column, int channel) {
        FloatVector radiance =
                FloatVector.fromArray(Lanes.FLOATS, tile.skyColors, PaddedSky.FLOATS_A_TEXEL * at + channel, PIXELS, 0);
        throughput.fma(radiance, Lanes.load(tile.values, at + column)).intoArray(tile.values, at + column);
    }
}
