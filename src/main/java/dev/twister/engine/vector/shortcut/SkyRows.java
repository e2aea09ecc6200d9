package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.PaddedSky;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.PatchList;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.ShortVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * {@link SkyPatches} for 16 lanes and a sky in bfloat16: each row of a patch is one vector, and each lane selects its
 * four texels from three rows. It calls no helpers; see {@link ShadowConics}. {@link Lanes#fma} is not needed either,
 * because every CPU with 16 lanes has a fused multiply-add.
 */
public final class SkyRows {
    /** Whether a vector holds a row of a patch. */
    static final boolean FIT = Lanes.COUNT == 16;

    /** Largest offset of a lane's left texel from the patch's first column; five texels are fifteen values. */
    private static final int MOST_TO_RIGHT = 3;

    /** Largest offset of a lane's upper texel from the patch's first row. */
    private static final int MOST_TO_BOTTOM = 1;

    /** Bits of a lane's index: in a selection from two vectors, the second one's lanes start at 16. */
    private static final int LANE_BITS = 4;

    /** Adding it rounds small numbers to integers, which are then in the float's lowest bits. */
    static final float ROUNDER = 3 << 22;

    private static final VectorSpecies<Short> HALVES = ShortVector.SPECIES_256;

    private SkyRows() {}

    /**
     * Separates the packets that see a patch from the scattered ones. A patch starts one column before that of any
     * lane, which is found faster than the leftmost one, and in the upper of two rows.
     */
    static void sort(Tile tile) {
        float[] t = tile.values;
        PatchList patches = tile.skyPatches;
        patches.clear();
        tile.scatteredSkies.clear();
        for (int k = 0; k < tile.skies.count; k++) {
            int at = tile.skies.places[k];
            long met = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT)
                    .compare(VectorOperators.EQ, Layout.NOTHING)
                    .toLong();
            FloatVector toRight = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SKY_TO_RIGHT);
            FloatVector toBottom = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SKY_TO_BOTTOM);
            int one = at + Long.numberOfTrailingZeros(met);
            int left = Math.max(0, (int) t[one + Tile.SKY_TO_RIGHT] - 1);
            int top = (int) t[one + Tile.SKY_TO_BOTTOM];
            long above = toBottom.compare(VectorOperators.LT, (float) top).toLong() & met;
            top -= (int) (-above >>> 63);
            VectorMask<Float> outside = toRight.compare(VectorOperators.LT, (float) left)
                    .or(toRight.compare(VectorOperators.GE, (float) (left + MOST_TO_RIGHT + 1)))
                    .or(toBottom.compare(VectorOperators.LT, (float) top))
                    .or(toBottom.compare(VectorOperators.GE, (float) (top + MOST_TO_BOTTOM + 1)));
            if ((outside.toLong() & met) == 0) {
                patches.places[patches.count] = at;
                patches.left[patches.count] = left;
                patches.top[patches.count] = top;
                patches.count++;
            } else {
                tile.scatteredSkies.add(at);
            }
        }
    }

    /** Adds the patches' radiance to the lanes that hit nothing. */
    static void add(Tile tile, PaddedSky sky) {
        float[] t = tile.values;
        short[] halves = sky.halves;
        PatchList patches = tile.skyPatches;
        int below = PaddedSky.NUMBERS_A_TEXEL * sky.stride();
        for (int k = 0; k < patches.count; k++) {
            int at = patches.places[k];
            int texel = PaddedSky.NUMBERS_A_TEXEL * (patches.top[k] * sky.stride() + patches.left[k]);
            IntVector first = ((IntVector) ShortVector.fromArray(HALVES, halves, texel)
                            .convertShape(VectorOperators.ZERO_EXTEND_S2I, Lanes.INTS, 0))
                    .lanewise(VectorOperators.LSHL, PaddedSky.LOWER_BITS);
            IntVector second = ((IntVector) ShortVector.fromArray(HALVES, halves, texel + below)
                            .convertShape(VectorOperators.ZERO_EXTEND_S2I, Lanes.INTS, 0))
                    .lanewise(VectorOperators.LSHL, PaddedSky.LOWER_BITS);
            IntVector third = ((IntVector) ShortVector.fromArray(HALVES, halves, texel + 2 * below)
                            .convertShape(VectorOperators.ZERO_EXTEND_S2I, Lanes.INTS, 0))
                    .lanewise(VectorOperators.LSHL, PaddedSky.LOWER_BITS);
            // Half a texel to the left, so that rounding gives the left texel; for an integer either neighbor is right.
            FloatVector toRight = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SKY_TO_RIGHT)
                    .sub(patches.left[k] + 0.5f);
            FloatVector toBottom = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SKY_TO_BOTTOM)
                    .sub(patches.top[k] + 0.5f);
            FloatVector column = toRight.add(ROUNDER);
            FloatVector row = toBottom.add(ROUNDER);
            toRight = toRight.sub(column.sub(ROUNDER)).add(0.5f);
            toBottom = toBottom.sub(row.sub(ROUNDER)).add(0.5f);
            // The rounder's own bits are above those that select a lane.
            IntVector number = column.reinterpretAsInts()
                    .add(column.reinterpretAsInts().lanewise(VectorOperators.LSHL, 1))
                    .add(row.reinterpretAsInts().lanewise(VectorOperators.LSHL, LANE_BITS));
            VectorMask<Float> met =
                    FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.NOTHING);
            FloatVector throughput = FloatVector.zero(Lanes.FLOATS)
                    .blend(
                            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.THROUGHPUT)
                                    .mul(sky.strength),
                            met);
            for (int channel = 0; channel < PaddedSky.NUMBERS_A_TEXEL; channel++) {
                IntVector left = number.add(channel);
                IntVector right = left.add(PaddedSky.NUMBERS_A_TEXEL);
                FloatVector upper = left.selectFrom(first, second).reinterpretAsFloats();
                FloatVector upperRight = right.selectFrom(first, second).reinterpretAsFloats();
                FloatVector lower = left.selectFrom(second, third).reinterpretAsFloats();
                FloatVector lowerRight = right.selectFrom(second, third).reinterpretAsFloats();
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
