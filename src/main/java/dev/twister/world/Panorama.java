package dev.twister.world;

import java.util.Arrays;

/**
 * The sky as the kernel reads it, and the textures after it.
 *
 * @param texels three floats each: the sky's linear radiance, row by row from the top, then the textures' colors
 *     likewise
 * @param dimensions the sky's width and height in texels; then each texture's first float, width and height
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record Panorama(float[] texels, int[] dimensions) {
    Panorama withDimensionsOf(Panorama earlier) {
        return Arrays.equals(earlier.dimensions, dimensions) ? new Panorama(texels, earlier.dimensions) : this;
    }
}
