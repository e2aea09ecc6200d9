package dev.twister.world;

import dev.twister.kernel.Layout;

/**
 * How a picture is taken, as the kernel reads it; {@link Layout} has the places in the arrays, none of which changes.
 *
 * @param dimensions {@code int[5]}: width and height of the picture in pixels, first row and number of rows to draw, bodies that
 *     are there
 * @param camera {@code float[13]}: position, right, up, forward, eye distance
 * @param properties {@code float[12]}
 * @param shadowDisc {@code float[2 * shadowSamples]}: the unit sunflower's points, {@code sqrt(i / n)} from the center
 * @param pixelOffsets {@code float[2 * samplesPerPixel]}: the samples' places in a pixel, x and y in (0, 1)
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record View(int[] dimensions, float[] camera, float[] properties, float[] shadowDisc, float[] pixelOffsets) {
    View withSize(int width, int height) {
        int[] sized = dimensions.clone();
        sized[Layout.WIDTH] = width;
        sized[Layout.HEIGHT] = height;
        return new View(sized, camera, properties, shadowDisc, pixelOffsets).withRows(0, height);
    }

    View withRows(int firstRow, int rows) {
        int[] banded = dimensions.clone();
        banded[Layout.FIRST_ROW] = firstRow;
        banded[Layout.ROWS] = rows;
        return new View(banded, camera, properties, shadowDisc, pixelOffsets);
    }

    View withSamples(int first, int samples) {
        float[] counted = properties.clone();
        counted[Layout.PIXEL_SAMPLES] = samples;
        return new View(dimensions, camera, counted, shadowDisc, PixelOffsets.places(first, samples));
    }
}
