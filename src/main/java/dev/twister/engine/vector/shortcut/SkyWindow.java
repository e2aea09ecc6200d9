package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.PaddedSky;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * The texels of the sky that a tile's rays see, if they are few enough that each color channel fits two vectors of 16
 * lanes, from which each lane selects its four. It calls no helpers; see {@link ShadowConics} and {@link SkyRows}.
 */
public final class SkyWindow {
    /** Whether vectors have 16 lanes. */
    static final boolean FIT = Lanes.COUNT == 16;

    /** Texels per vector and in total. */
    private static final int HALF = 16;

    private static final int MOST = 2 * HALF;

    /** The texels' float bits, row by row: red from {@link Lanes#BORDER} on, then green, then blue. */
    private final int[] texels = new int[Lanes.BORDER + PaddedSky.NUMBERS_A_TEXEL * MOST];

    private int left;
    private int top;
    private int columns;
    private int rows;
    private float strength;

    /** Loads the texels for a range of columns and rows of the padded sky; returns whether they fit. */
    boolean take(PaddedSky sky, float leftmost, float uppermost, float rightmost, float lowermost) {
        left = Math.max(0, (int) leftmost);
        top = Math.max(0, (int) uppermost);
        strength = sky.strength;
        columns = (int) rightmost + 2 - left;
        rows = (int) lowermost + 2 - top;
        boolean fits = columns * rows <= MOST;
        if (fits) {
            fetch(sky);
        }
        return fits;
    }

    private void fetch(PaddedSky sky) {
        int to = Lanes.BORDER;
        for (int row = 0; row < rows; row++) {
            int from = PaddedSky.NUMBERS_A_TEXEL * ((top + row) * sky.stride() + left);
            for (int column = 0; column < columns; column++) {
                texels[to] = sky.bits(from);
                texels[to + MOST] = sky.bits(from + 1);
                texels[to + 2 * MOST] = sky.bits(from + 2);
                from += PaddedSky.NUMBERS_A_TEXEL;
                to++;
            }
        }
    }

    /** Adds the radiance to the lanes that hit nothing. */
    void add(Tile tile) {
        float[] t = tile.values;
        int[] colors = texels;
        float fromLeft = left + 0.5f;
        float fromTop = top + 0.5f;
        float across = columns;
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            FloatVector toRight = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SKY_TO_RIGHT)
                    .sub(fromLeft);
            FloatVector toBottom = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SKY_TO_BOTTOM)
                    .sub(fromTop);
            FloatVector column = toRight.add(SkyRows.ROUNDER);
            FloatVector row = toBottom.add(SkyRows.ROUNDER).sub(SkyRows.ROUNDER);
            toRight = toRight.sub(column.sub(SkyRows.ROUNDER)).add(0.5f);
            toBottom = toBottom.sub(row).add(0.5f);
            IntVector corner =
                    row.fma(FloatVector.broadcast(Lanes.FLOATS, across), column).reinterpretAsInts();
            IntVector right = corner.add(1);
            IntVector below = corner.add(columns);
            IntVector belowRight = right.add(columns);
            VectorMask<Float> met =
                    FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.NOTHING);
            FloatVector throughput = FloatVector.zero(Lanes.FLOATS)
                    .blend(
                            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.THROUGHPUT)
                                    .mul(strength),
                            met);
            for (int channel = 0; channel < PaddedSky.NUMBERS_A_TEXEL; channel++) {
                int from = Lanes.BORDER + channel * MOST;
                IntVector first = IntVector.fromArray(Lanes.INTS, colors, from);
                IntVector second = IntVector.fromArray(Lanes.INTS, colors, from + HALF);
                FloatVector upper = corner.selectFrom(first, second).reinterpretAsFloats();
                FloatVector upperRight = right.selectFrom(first, second).reinterpretAsFloats();
                FloatVector lower = below.selectFrom(first, second).reinterpretAsFloats();
                FloatVector lowerRight = belowRight.selectFrom(first, second).reinterpretAsFloats();
                upper = upperRight.sub(upper).fma(toRight, upper);
                lower = lowerRight.sub(lower).fma(toRight, lower);
                int color = at + Tile.RED + channel * Tile.SIZE;
                throughput
                        .fma(lower.sub(upper).fma(toBottom, upper), FloatVector.fromArray(Lanes.FLOATS, t, color))
                        .intoArray(t, color);
            }
        }
    }
}
