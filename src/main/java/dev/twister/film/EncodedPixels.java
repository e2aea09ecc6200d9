package dev.twister.film;

import java.util.stream.IntStream;

/** Converts pixels to sRGB, the encoding of films. */
public final class EncodedPixels {
    private static final int LEVELS = 256;

    private static final double WHITE = 255;
    private static final double LINEAR_PART = 0.0031308;

    private EncodedPixels() {}

    /** The pixels sRGB-encoded; the same array if they are already. */
    public static int[] of(int[] argb, boolean srgb) {
        if (srgb) {
            return argb;
        }
        int[] curve = IntStream.range(0, LEVELS).map(EncodedPixels::encoded).toArray();
        int[] encoded = new int[argb.length];
        for (int i = 0; i < argb.length; i++) {
            int pixel = argb[i];
            encoded[i] = (pixel & 0xff000000)
                    | curve[pixel >> 16 & 0xff] << 16
                    | curve[pixel >> 8 & 0xff] << 8
                    | curve[pixel & 0xff];
        }
        return encoded;
    }

    private static int encoded(int level) {
        double light = level / WHITE;
        double shown = light <= LINEAR_PART ? 12.92 * light : 1.055 * Math.pow(light, 1 / 2.4) - 0.055;
        return (int) Math.round(WHITE * shown);
    }
}
