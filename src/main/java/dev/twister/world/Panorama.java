package dev.twister.world;

import java.util.Arrays;

/**
 * The sky and the textures as the kernel reads them.
 *
 * @param texels three floats per texel: the sky's linear radiance, row by row from the top, then the textures' colors
 * @param dimensions the sky's width and height in texels; then start, width and height of each texture
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record Panorama(float[] texels, int[] dimensions) {
    Panorama withDimensionsOf(Panorama earlier) {
        return Arrays.equals(earlier.dimensions, dimensions) ? new Panorama(texels, earlier.dimensions) : this;
    }
}
