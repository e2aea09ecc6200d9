package dev.twister.oracle;

/**
 * A range of colors, per channel.
 *
 * @param lowest as 0xAARRGGBB
 * @param highest as 0xAARRGGBB
 */
record PixelSpan(int lowest, int highest) {
    /** Returns whether every channel of a color is in the range or at most 1 of 255 outside. */
    boolean holds(int argb) {
        boolean holds = true;
        for (int shift = 0; shift < 24; shift += 8) {
            int channel = argb >> shift & 0xFF;
            holds = holds && channel >= (lowest >> shift & 0xFF) - 1 && channel <= (highest >> shift & 0xFF) + 1;
        }
        return holds;
    }
}
