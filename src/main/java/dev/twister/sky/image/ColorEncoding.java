package dev.twister.sky.image;

/** What the samples of an image mean: how they become linear sRGB light. */
interface ColorEncoding {
    /**
     * For an image's rows.
     *
     * @param width texels in a row
     * @param channels 1 for gray, 3 for red, green and blue
     * @param largest what a sample is at most, up to 65535
     */
    ColorRows rows(int width, int channels, int largest);
}
