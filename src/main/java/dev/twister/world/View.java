package dev.twister.world;

import dev.twister.kernel.Aspect;
import dev.twister.kernel.Layout;

/**
 * Camera and settings of a picture as the kernel reads them. {@link Layout} describes the arrays, which are immutable.
 *
 * @param dimensions {@code int[5]}: width and height of the picture in pixels, first row and number of rows to render,
 *     number of present bodies
 * @param camera {@code float[15]}: position, right, up, forward, eye distance, aperture, focus distance
 * @param properties {@code float[12]}
 * @param shadowDisc {@code float[2 * shadowSamples]}: points of the unit sunflower, {@code sqrt(i / n)} from the center
 * @param pixelSamples {@code float[16 * samplesPerPixel]}: positions of the samples in a pixel, and random numbers for
 *     lens and surfaces
 * @param aspect what to render: a constant of {@link Aspect}
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record View(
        int[] dimensions, float[] camera, float[] properties, float[] shadowDisc, float[] pixelSamples, int aspect) {
    View withSize(int width, int height) {
        int[] sized = dimensions.clone();
        sized[Layout.WIDTH] = width;
        sized[Layout.HEIGHT] = height;
        return new View(sized, camera, properties, shadowDisc, pixelSamples, aspect).withRows(0, height);
    }

    View withRows(int firstRow, int rows) {
        int[] banded = dimensions.clone();
        banded[Layout.FIRST_ROW] = firstRow;
        banded[Layout.ROWS] = rows;
        return new View(banded, camera, properties, shadowDisc, pixelSamples, aspect);
    }

    View withSamples(int first, int samples) {
        float[] counted = properties.clone();
        counted[Layout.PIXEL_SAMPLES] = samples;
        return new View(dimensions, camera, counted, shadowDisc, PixelSamples.of(first, samples), aspect);
    }

    View showing(Picture picture) {
        float[] shown = properties.clone();
        if (!picture.bounces()) {
            shown[Layout.BOUNCES] = 0;
        }
        boolean hard = picture == Picture.HARD_SHADOWS;
        if (hard) {
            shown[Layout.SHADOW_SAMPLES] = 1;
        }
        return new View(
                dimensions, camera, shown, hard ? SunflowerDisc.points(1) : shadowDisc, pixelSamples, picture.aspect());
    }
}
