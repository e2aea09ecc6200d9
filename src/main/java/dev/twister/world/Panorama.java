package dev.twister.world;

import java.util.Arrays;

/**
 * The sky as the kernel reads it.
 *
 * @param texels {@code float[3 * width * height]}: linear radiance, row by row from the top
 * @param dimensions {@code int[2]}: width, height in texels
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record Panorama(float[] texels, int[] dimensions) {
    Panorama withDimensionsOf(Panorama earlier) {
        return Arrays.equals(earlier.dimensions, dimensions) ? new Panorama(texels, earlier.dimensions) : this;
    }
}
