package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.PaddedSky;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Bilinear radiance of the panorama for packets whose lanes see scattered texels. Texels are fetched pixel by pixel and
 * interpolated in lanes.
 *
 * <p>All vectors have the packet's width, except in {@code SkyRows}, which unpacks shorts: the Vector API's methods
 * profile the widths that they see, and C2 allocates vectors where the profile is ambiguous.
 */
public final class SkyRadiance {
    private SkyRadiance() {}

    /** Adds the radiance to the scattered packets. */
    public static void lookUp(PaddedSky sky, Tile tile) {
        listPixels(tile);
        findTexels(tile, sky);
        fetch(tile, sky);
        unpack(tile, sky);
        add(tile, sky);
    }

    /** Lists the pixels that hit nothing. */
    static void listPixels(Tile tile) {
        float[] t = tile.values;
        int count = 0;
        for (int k = 0; k < tile.scatteredSkies.count; k++) {
            int at = tile.scatteredSkies.places[k];
            long met = Lanes.load(t, at + Tile.HIT)
                    .compare(VectorOperators.EQ, Layout.NOTHING)
                    .toLong();
            Lanes.pack(tile.pixels, at, met, tile.lonely.pixels, count);
            count += Long.bitCount(met);
        }
        tile.lonely.count = count;
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

    /** Fetches the four texels around each listed pixel's direction, pixel by pixel. */
    static void fetch(Tile tile, PaddedSky sky) {
        if (sky.isShared()) {
            fetchShared(tile, sky);
        } else {
            fetchNumbers(tile, sky);
        }
    }

    private static void fetchShared(Tile tile, PaddedSky sky) {
        int[] from = sky.shared;
        int[] to = tile.corners;
        int below = sky.stride();
        for (int k = 0; k < tile.lonely.count; k++) {
            int pixel = tile.lonely.pixels[k];
            int texel = tile.texels[pixel];
            int upperLeft = from[texel];
            int upperRight = from[texel + 1];
            int lowerLeft = from[texel + below];
            int lowerRight = from[texel + below + 1];
            to[Tile.UPPER_LEFT + pixel] = upperLeft;
            to[Tile.UPPER_RIGHT + pixel] = upperRight;
            to[Tile.LOWER_LEFT + pixel] = lowerLeft;
            to[Tile.LOWER_RIGHT + pixel] = lowerRight;
        }
    }

    private static void fetchNumbers(Tile tile, PaddedSky sky) {
        float[] to = tile.cornerNumbers;
        int below = PaddedSky.NUMBERS_A_TEXEL * sky.stride();
        for (int k = 0; k < tile.lonely.count; k++) {
            int pixel = tile.lonely.pixels[k];
            int texel = PaddedSky.NUMBERS_A_TEXEL * tile.texels[pixel];
            for (int channel = 0; channel < PaddedSky.NUMBERS_A_TEXEL; channel++) {
                int place = Tile.CORNERS * channel * Tile.SIZE + pixel;
                int number = texel + channel;
                to[Tile.UPPER_LEFT + place] = sky.value(number);
                to[Tile.UPPER_RIGHT + place] = sky.value(number + PaddedSky.NUMBERS_A_TEXEL);
                to[Tile.LOWER_LEFT + place] = sky.value(number + below);
                to[Tile.LOWER_RIGHT + place] = sky.value(number + below + PaddedSky.NUMBERS_A_TEXEL);
            }
        }
    }

    /** Decodes shared texels. */
    static void unpack(Tile tile, PaddedSky sky) {
        if (sky.isShared()) {
            for (int corner = 0; corner < Tile.CORNERS * Tile.SIZE; corner += Tile.SIZE) {
                unpack(corner, tile);
            }
        }
    }

    private static void unpack(int corner, Tile tile) {
        int[] from = tile.corners;
        float[] to = tile.cornerNumbers;
        for (int k = 0; k < tile.scatteredSkies.count; k++) {
            int at = Tile.UPPER_LEFT + corner + tile.scatteredSkies.places[k];
            IntVector texels = IntVector.fromArray(Lanes.INTS, from, at);
            FloatVector unit = texels.lanewise(VectorOperators.LSHR, 1)
                    .and(PaddedSky.EXPONENT)
                    .reinterpretAsFloats();
            Lanes.toFloats(texels.and(PaddedSky.MANTISSA)).mul(unit).intoArray(to, at);
            Lanes.toFloats(texels.lanewise(VectorOperators.LSHR, PaddedSky.MANTISSA_BITS)
                            .and(PaddedSky.MANTISSA))
                    .mul(unit)
                    .intoArray(to, at + Tile.CORNERS * Tile.SIZE);
            Lanes.toFloats(texels.lanewise(VectorOperators.LSHR, 2 * PaddedSky.MANTISSA_BITS)
                            .and(PaddedSky.MANTISSA))
                    .mul(unit)
                    .intoArray(to, at + 2 * Tile.CORNERS * Tile.SIZE);
        }
    }

    /** Adds the interpolated radiance to the lanes that hit nothing. */
    public static void add(Tile tile, PaddedSky sky) {
        for (int channel = 0; channel < PaddedSky.NUMBERS_A_TEXEL; channel++) {
            add(sky.strength, Tile.RED + channel * Tile.SIZE, Tile.CORNERS * channel * Tile.SIZE, tile);
        }
    }

    private static void add(float strength, int color, int column, Tile tile) {
        float[] t = tile.values;
        float[] corners = tile.cornerNumbers;
        for (int k = 0; k < tile.scatteredSkies.count; k++) {
            int at = tile.scatteredSkies.places[k];
            FloatVector toRight = Lanes.load(t, at + Tile.SKY_TO_RIGHT);
            FloatVector upper = Lanes.load(corners, Tile.UPPER_LEFT + column + at);
            FloatVector lower = Lanes.load(corners, Tile.LOWER_LEFT + column + at);
            FloatVector upperEnd = Lanes.load(corners, Tile.UPPER_RIGHT + column + at);
            FloatVector lowerEnd = Lanes.load(corners, Tile.LOWER_RIGHT + column + at);
            upper = Lanes.fma(upperEnd.sub(upper), toRight, upper);
            lower = Lanes.fma(lowerEnd.sub(lower), toRight, lower);
            FloatVector radiance = Lanes.fma(lower.sub(upper), Lanes.load(t, at + Tile.SKY_TO_BOTTOM), upper);
            FloatVector before = Lanes.load(t, at + color);
            VectorMask<Float> met = Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.NOTHING);
            before.blend(Lanes.fma(Lanes.load(t, at + Tile.THROUGHPUT).mul(strength), radiance, before), met)
                    .intoArray(t, at + color);
        }
    }
}
