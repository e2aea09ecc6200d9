package dev.twister.sky;

/** What the samples of an image mean: how they become linear sRGB light. */
interface ColorEncoding {
    /** Converts rows of one image. */
    interface Rows {
        /**
         * Converts a row.
         *
         * @param samples of all color channels, texel by texel, each 0 to the largest
         * @param linear receives red, green and blue of each texel, 0 to 1
         */
        void convert(int[] samples, float[] linear);
    }

    /**
     * For an image's rows.
     *
     * @param width texels in a row
     * @param channels 1 for gray, 3 for red, green and blue
     * @param largest what a sample is at most, up to 65535
     */
    Rows rows(int width, int channels, int largest);
}
