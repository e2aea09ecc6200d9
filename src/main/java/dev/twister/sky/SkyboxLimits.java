package dev.twister.sky;

import java.io.IOException;

/** How large a panorama may be, so that a broken or hostile file cannot ask for all the memory there is. */
public final class SkyboxLimits {
    /** Texels around the horizon. */
    static final int WIDTH = 16384;

    /** Texels from straight up to straight down. */
    static final int HEIGHT = 8192;

    /** Bytes in a file: the largest panorama at eight bytes a texel, as an uncompressed 16-bit RGBA image has. */
    static final long FILE_BYTES = 8L * WIDTH * HEIGHT;

    private SkyboxLimits() {}

    /** Checks what a header claims before anything is allocated for it. */
    public static void checkSize(long width, long height) throws IOException {
        if (width < 1 || height < 1 || width > WIDTH || height > HEIGHT) {
            throw notAllowed(width, height);
        }
    }

    /** Checks a size of which it is not known yet which side is the width. */
    public static void checkEitherWay(long width, long height) throws IOException {
        if (Math.min(width, height) < 1 || Math.max(width, height) > WIDTH || Math.min(width, height) > HEIGHT) {
            throw notAllowed(width, height);
        }
    }

    private static IOException notAllowed(long width, long height) {
        return new IOException(width + " x " + height + " texels; 1 x 1 to " + WIDTH + " x " + HEIGHT + " are allowed");
    }
}
