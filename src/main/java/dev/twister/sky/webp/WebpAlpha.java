package dev.twister.sky.webp;

import java.io.IOException;

/** The alpha of a lossy picture (RFC 9649, section 2.7.1.2). */
final class WebpAlpha {
    private static final int PLAIN = 0;
    private static final int LOSSLESS = 1;
    private static final int HORIZONTAL = 1;
    private static final int VERTICAL = 2;
    private static final int GRADIENT = 3;

    private WebpAlpha() {}

    /** Decodes a chunk's data into the alpha of texels. */
    static void put(byte[] chunk, int width, int height, int[] argb) throws IOException {
        WebpDamage.check(chunk.length > 1 && (chunk[0] & 0xc0) == 0, "its alpha has no data");
        int compression = chunk[0] & 3;
        int filter = chunk[0] >> 2 & 3;
        byte[] alpha = new byte[width * height];
        if (compression == PLAIN) {
            if (chunk.length - 1 < alpha.length) {
                throw WebpDamage.truncated();
            }
            System.arraycopy(chunk, 1, alpha, 0, alpha.length);
        } else {
            WebpDamage.check(compression == LOSSLESS, "an unknown compression of its alpha");
            int[] green = Lossless.decode(new LosslessBits(chunk, 1, chunk.length), width, height);
            for (int i = 0; i < alpha.length; i++) {
                alpha[i] = (byte) (green[i] >> 8);
            }
        }
        unfilter(alpha, width, filter);
        for (int i = 0; i < alpha.length; i++) {
            argb[i] = (argb[i] & 0xffffff) | alpha[i] << 24;
        }
    }

    private static void unfilter(byte[] alpha, int width, int filter) {
        for (int i = 1; filter != 0 && i < alpha.length; i++) {
            alpha[i] += (byte) prediction(alpha, i, width, filter);
        }
    }

    private static int prediction(byte[] alpha, int i, int width, int filter) {
        boolean top = i < width;
        boolean left = i % width == 0;
        if (top || (!left && filter == HORIZONTAL)) {
            return alpha[i - 1];
        }
        if (left || filter == VERTICAL) {
            return alpha[i - width];
        }
        return filter == GRADIENT
                ? Math.clamp((alpha[i - 1] & 0xff) + (alpha[i - width] & 0xff) - (alpha[i - width - 1] & 0xff), 0, 255)
                : 0;
    }
}
