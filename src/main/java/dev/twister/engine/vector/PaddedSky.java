package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;
import jdk.incubator.vector.FloatVector;

/**
 * The panorama with a border of one texel, which wraps in the columns and repeats in the rows: the four texels about any
 * direction then lie at fixed distances. Kept while the input's sky is the same.
 *
 * <p>A texel is three numbers, red, green and blue: the upper halves of floats where that loses nothing (bfloat16; the
 * mantissas of a Radiance picture have eight bits, and so has a half) and the CPU unpacks eight of them at once, whole
 * floats otherwise. Half of the memory keeps more of the sky near the processor.
 */
final class PaddedSky {
    static final int NUMBERS_A_TEXEL = 3;

    /** Bits of a float that a half leaves out. */
    static final int LOWER_BITS = 16;

    /** A vector that starts at a texel may reach that many numbers, or one row, beyond the last one. */
    private static final int BLANKS = 16;

    /** Rows above and below the panorama, and a blank one. */
    private static final int MORE_ROWS = 3;

    private static final boolean WIDE_ENOUGH = FloatVector.SPECIES_PREFERRED.vectorBitSize() >= 256;

    /** The texels row by row, if not {@link #halved}. */
    float[] floats = {};

    /** The texels row by row, if {@link #halved}. */
    short[] halves = {};

    boolean halved;

    /** In texels, without the border. */
    int width;

    int height;

    private float[] source;

    /** Texels from one row to the next. */
    int stride() {
        return width + 2;
    }

    /** One number of a texel. */
    float value(int at) {
        return halved ? Float.intBitsToFloat(halves[at] << LOWER_BITS) : floats[at];
    }

    @SuppressWarnings("ReferenceEquality") // an input's arrays never change
    void take(FrameInput input) {
        if (input.skybox() != source) {
            source = input.skybox();
            width = input.skyboxDimensions()[Layout.SKYBOX_WIDTH];
            height = input.skyboxDimensions()[Layout.SKYBOX_HEIGHT];
            halved = WIDE_ENOUGH && fitHalves(source);
            int room = BLANKS + Math.multiplyExact(NUMBERS_A_TEXEL, Math.multiplyExact(stride(), height + MORE_ROWS));
            floats = new float[halved ? 0 : room];
            halves = new short[halved ? room : 0];
            for (int row = -1; row <= height; row++) {
                copyRow(row);
            }
        }
    }

    private static boolean fitHalves(float[] radiance) {
        int lower = 0;
        for (float value : radiance) {
            lower |= Float.floatToRawIntBits(value) << LOWER_BITS;
        }
        return lower == 0;
    }

    private void copyRow(int row) {
        int from = NUMBERS_A_TEXEL * width * Math.clamp(row, 0, height - 1);
        int to = NUMBERS_A_TEXEL * stride() * (row + 1);
        for (int column = -1; column <= width; column++) {
            int texel = from + NUMBERS_A_TEXEL * Math.floorMod(column, width);
            for (int channel = 0; channel < NUMBERS_A_TEXEL; channel++) {
                put(to + channel, source[texel + channel]);
            }
            to += NUMBERS_A_TEXEL;
        }
    }

    private void put(int at, float value) {
        if (halved) {
            halves[at] = (short) (Float.floatToRawIntBits(value) >>> LOWER_BITS);
        } else {
            floats[at] = value;
        }
    }
}
