package dev.twister.oracle;

/**
 * Two colors that a pixel swings between, channel by channel.
 *
 * @param lowest as 0xAARRGGBB
 * @param highest as 0xAARRGGBB
 */
record PixelSpan(int lowest, int highest) {
    /** Whether a color lies between, or at most 1 of 255 outside, in every channel. */
    boolean holds(int argb) {
        boolean holds = true;
        for (int shift = 0; shift < 24; shift += 8) {
            int channel = argb >> shift & 0xFF;
            holds = holds && channel >= (lowest >> shift & 0xFF) - 1 && channel <= (highest >> shift & 0xFF) + 1;
        }
        return holds;
    }
}
