package dev.twister.engine.vector.frame;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/**
 * The panorama with a border of one texel, which wraps in the columns and repeats in the rows: the four texels about
 * any direction then lie at fixed distances. Kept while the input's sky is the same.
 *
 * <p>A texel is three numbers, red, green and blue: the upper halves of floats where that loses nothing (bfloat16; the
 * mantissas of a Radiance picture have eight bits, and so has a half), whole floats otherwise. Where the three of every
 * texel can share an exponent, as a Radiance picture has it, there is each texel in one int besides. The less memory,
 * the more of the sky stays near the processor.
 */
public final class PaddedSky {
    public static final int NUMBERS_A_TEXEL = 3;

    /** Bits of a float that a half leaves out. */
    public static final int LOWER_BITS = 16;

    /** A vector that starts at a texel may reach that many numbers, or one row, beyond the last one. */
    private static final int BLANKS = 16;

    /** Rows above and below the panorama, and a blank one. */
    private static final int MORE_ROWS = 3;

    /** In a shared texel, a number's bits. */
    public static final int MANTISSA_BITS = 8;

    public static final int MANTISSA = 255;

    /** The exponent's bits in a float. */
    public static final int EXPONENT = 0x7F800000;

    /**
     * The texels row by row, if all fit, or none: red, green and blue as whole numbers from the lowest bits on,
     * {@link #MANTISSA_BITS} each, above them the exponent of what they are to be multiplied by, as a float has it. A
     * Radiance picture is stored in this way.
     */
    public int[] shared = {};

    /** The texels row by row, if not {@link #halved}. */
    float[] floats = {};

    /** The texels row by row, if {@link #halved}. */
    public short[] halves = {};

    public boolean halved;

    /** In texels, without the border. */
    public int width;

    public int height;

    /** How far the panorama is turned to the right, in whole turns, in [0, 1). */
    public float turn;

    /** What the texels are to be multiplied by. */
    public float strength;

    private float[] source;

    /** Texels from one row to the next. */
    public int stride() {
        return width + 2;
    }

    /** One number of a texel. */
    public float value(int at) {
        return halved ? Float.intBitsToFloat(halves[at] << LOWER_BITS) : floats[at];
    }

    /** The bits of the same as a float. */
    public int bits(int at) {
        return halved ? halves[at] << LOWER_BITS : Float.floatToRawIntBits(floats[at]);
    }

    @SuppressWarnings("ReferenceEquality") // an input's arrays never change
    public void take(FrameInput input) {
        turn = input.view().properties()[Layout.SKY_TURN];
        strength = input.view().properties()[Layout.SKY_STRENGTH];
        if (input.panorama().texels() != source) {
            source = input.panorama().texels();
            width = input.panorama().dimensions()[Layout.SKY_WIDTH];
            height = input.panorama().dimensions()[Layout.SKY_HEIGHT];
            int end = NUMBERS_A_TEXEL * width * height;
            halved = fitHalves(source, end);
            int room = BLANKS + Math.multiplyExact(NUMBERS_A_TEXEL, Math.multiplyExact(stride(), height + MORE_ROWS));
            floats = new float[halved ? 0 : room];
            halves = new short[halved ? room : 0];
            shared = new int[halved && fitShared(source, end) ? Math.multiplyExact(stride(), height + MORE_ROWS) : 0];
            for (int row = -1; row <= height; row++) {
                copyRow(row);
            }
        }
    }

    /** Whether the texels are {@link #shared}. */
    public boolean isShared() {
        return shared.length > 0;
    }

    private static boolean fitShared(float[] radiance, int end) {
        boolean fit = true;
        for (int texel = 0; texel < end && fit; texel += NUMBERS_A_TEXEL) {
            fit = fitsShared(radiance, texel);
        }
        return fit;
    }

    private static boolean fitsShared(float[] radiance, int texel) {
        int bits = share(radiance, texel);
        boolean fits = true;
        for (int channel = 0; channel < NUMBERS_A_TEXEL; channel++) {
            fits &= shared(bits, channel) == radiance[texel + channel];
        }
        return fits;
    }

    /** A number of a shared texel. */
    private static float shared(int bits, int channel) {
        return Float.intBitsToFloat(bits >>> 1 & EXPONENT) * (bits >>> (MANTISSA_BITS * channel) & MANTISSA);
    }

    /** A texel whose numbers share an exponent; other numbers than the texel's where they cannot. */
    private static int share(float[] radiance, int texel) {
        float most = Math.max(radiance[texel], Math.max(radiance[texel + 1], radiance[texel + 2]));
        int exponent = Math.getExponent(most) - (MANTISSA_BITS - 1);
        int bits = 0;
        if (exponent >= Float.MIN_EXPONENT) {
            bits = (exponent + Float.MAX_EXPONENT) << (NUMBERS_A_TEXEL * MANTISSA_BITS);
            float inverse = Float.intBitsToFloat((Float.MAX_EXPONENT - exponent) << (Float.PRECISION - 1));
            for (int channel = 0; channel < NUMBERS_A_TEXEL; channel++) {
                bits |= ((int) (radiance[texel + channel] * inverse) & MANTISSA) << (MANTISSA_BITS * channel);
            }
        }
        return bits;
    }

    private static boolean fitHalves(float[] radiance, int end) {
        int lower = 0;
        for (int at = 0; at < end; at++) {
            lower |= Float.floatToRawIntBits(radiance[at]) << LOWER_BITS;
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
            if (isShared()) {
                shared[to / NUMBERS_A_TEXEL] = share(source, texel);
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
