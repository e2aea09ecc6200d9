package dev.twister.denoise;

/**
 * Bands of rows in which a large picture is denoised, so that the memory outside the heap is bounded. A band is
 * denoised with rows above and below that the denoiser looks at.
 *
 * @param width of the picture in pixels
 * @param height of the picture
 * @param rows of each band that are kept; the last one may have fewer
 */
record Bands(int width, int height, int rows) {
    /** Rows beyond a kept one that the network sees, rounded up to its alignment. */
    static final int OVERLAP = 128;

    /** Limit of the pixels of a band with its overlap, so that its memory is bounded. */
    static final long MOST_PIXELS = 1 << 24;

    /**
     * The bands of a picture.
     *
     * @param mostPixels limit of the pixels of a band with its overlap, unless the picture is too wide for it
     */
    static Bands of(int width, int height, long mostPixels) {
        long whole = Math.max(1, mostPixels / width);
        return new Bands(width, height, (int) (whole >= height ? height : Math.max(OVERLAP, whole - 2 * OVERLAP)));
    }

    /** Number of bands. */
    int count() {
        return Math.ceilDiv(height, rows);
    }

    /** The first row that is kept. */
    int first(int band) {
        return band * rows;
    }

    /** The row after the last one that is kept. */
    int end(int band) {
        return Math.min(height, first(band) + rows);
    }

    /** The first row that is denoised. */
    int top(int band) {
        return Math.max(0, first(band) - OVERLAP);
    }

    /** The row after the last one that is denoised. */
    int bottom(int band) {
        return Math.min(height, end(band) + OVERLAP);
    }
}
