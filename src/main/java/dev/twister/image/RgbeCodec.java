package dev.twister.image;

/** Floats to shared-exponent texels (Ward, "Real Pixels", Graphics Gems II, 1991), rounded to nearest. */
final class RgbeCodec {
    private static final double LARGEST = 255 * 0x1p119;
    private static final double SMALLEST = 0x1p-128;

    private RgbeCodec() {}

    /**
     * Encodes one texel. A texel that is not black has a largest mantissa of 128 or more, so that no texel of a flat
     * row looks like a run length code, (1, 1, 1, n) or (2, 2, n, n).
     *
     * @param radiance red, green, blue from index {@code from} on; any values
     * @param rgbe receives three mantissas and the exponent from index {@code to} on
     */
    static void encode(float[] radiance, int from, byte[] rgbe, int to) {
        double red = representable(radiance[from]);
        double green = representable(radiance[from + 1]);
        double blue = representable(radiance[from + 2]);
        double largest = Math.max(red, Math.max(green, blue));
        if (largest < SMALLEST) {
            rgbe[to] = 0;
            rgbe[to + 1] = 0;
            rgbe[to + 2] = 0;
            rgbe[to + 3] = 0;
            return;
        }
        int exponent = Math.getExponent(largest) + 1;
        rgbe[to] = mantissa(red, exponent);
        rgbe[to + 1] = mantissa(green, exponent);
        rgbe[to + 2] = mantissa(blue, exponent);
        rgbe[to + 3] = (byte) (exponent + 128);
    }

    /** Limited to 255 instead of carrying into the exponent, which would double the error of the other two channels. */
    private static byte mantissa(double channel, int exponent) {
        return (byte) Math.min(255, Math.rint(Math.scalb(channel, 8 - exponent)));
    }

    private static double representable(float channel) {
        return channel > 0 ? Math.min(channel, LARGEST) : 0;
    }
}
