package dev.twister.sky.webp;

/** What was done to a picture before it was stored as VP8L (RFC 9649, section 3.5). */
interface LosslessTransform {
    /** Undoes it, in place where the number of texels stays. */
    int[] inverse(int[] argb);

    /** Undoes that green was subtracted from red and blue. */
    static int[] addGreen(int[] argb) {
        for (int i = 0; i < argb.length; i++) {
            int green = argb[i] >> 8 & 0xff;
            argb[i] = (argb[i] & 0xff00ff00) | ((argb[i] & 0xff00ff) + (green << 16 | green) & 0xff00ff);
        }
        return argb;
    }

    /** The sum of two texels, each channel by itself, modulo 256. */
    static int sum(int a, int b) {
        return ((a & 0xff00ff00) + (b & 0xff00ff00) & 0xff00ff00) | ((a & 0xff00ff) + (b & 0xff00ff) & 0xff00ff);
    }

    /** The number of blocks along a side, each of 2 to the power of blockBits texels; the last may be shorter. */
    static int blocks(int length, int blockBits) {
        return (length + (1 << blockBits) - 1) >> blockBits;
    }
}
