package dev.twister.engine.vector.frame;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/**
 * The panorama with a border of one texel, wrapped horizontally and clamped vertically, so that the four texels around
 * any direction are at fixed offsets. Reused while the input's sky is the same.
 *
 * <p>A texel has three values: red, green and blue. They are stored as bfloat16 (the upper halves of floats) where that
 * is lossless, as it is for a Radiance picture with its 8-bit mantissas; otherwise as floats. Where the three values of
 * every texel can share an exponent, each texel is also stored as one int. Smaller texels keep more of the sky in the
 * CPU's caches.
 */
public final class PaddedSky {
    public static final int NUMBERS_A_TEXEL = 3;

    /** Bits of a float that bfloat16 omits. */
    public static final int LOWER_BITS = 16;

    /** Padding: a vector that starts at the last texel may read this many values, or one row, beyond it. */
    private static final int BLANKS = 16;

    /** The border rows above and below the panorama, and a row of padding. */
    private static final int MORE_ROWS = 3;

    /** Bits per channel in a shared texel. */
    public static final int MANTISSA_BITS = 8;

    public static final int MANTISSA = 255;

    /** Exponent bits of a float. */
    public static final int EXPONENT = 0x7F800000;

    /**
     * The texels row by row if all can share an exponent, else empty: red, green and blue as integers of
     * {@link #MANTISSA_BITS} bits from the lowest bits on, above them the biased exponent of their common factor.
     * Radiance pictures use the same encoding.
     */
    public int[] shared = {};

    /** The texels' channels row by row, unless {@link #halved}. */
    float[] floats = {};

    /** The texels' channels row by row as bfloat16, if {@link #halved}. */
    public short[] halves = {};

    public boolean halved;

    /** Size in texels, without the border. */
    public int width;

    public int height;

    /** Rotation of the panorama to the right, in turns, in [0, 1). */
    public float turn;

    /** Factor for the texels. */
    public float strength;

    private float[] source;

    /** Distance between rows, in texels. */
    public int stride() {
        return width + 2;
    }

    /** One channel of a texel. */
    public float value(int at) {
        return halved ? Float.intBitsToFloat(halves[at] << LOWER_BITS) : floats[at];
    }

    /** Float bits of one channel of a texel. */
    public int bits(int at) {
        return halved ? halves[at] << LOWER_BITS : Float.floatToRawIntBits(floats[at]);
    }

    @SuppressWarnings("ReferenceEquality") // an input's arrays are immutable
    public void take(FrameInput input) {
        turn = input.view().frame()[Layout.SKY_TURN];
        strength = input.view().frame()[Layout.SKY_STRENGTH];
        if (input.images() != source) {
            source = input.images();
            width = (int) input.view().frame()[Layout.SKY_WIDTH];
            height = (int) input.view().frame()[Layout.SKY_HEIGHT];
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

    /** Decodes one channel of a shared texel. */
    private static float shared(int bits, int channel) {
        return Float.intBitsToFloat(bits >>> 1 & EXPONENT) * (bits >>> (MANTISSA_BITS * channel) & MANTISSA);
    }

    /** Encodes a texel with a shared exponent; lossy where its channels do not fit. */
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
