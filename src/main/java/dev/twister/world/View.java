package dev.twister.world;

import dev.twister.kernel.Aspect;
import dev.twister.kernel.Layout;

/**
 * How a picture is taken, as the kernel reads it; {@link Layout} has the places in the arrays, none of which changes.
 *
 * @param dimensions {@code int[5]}: width and height of the picture in pixels, first row and number of rows to draw,
 *     bodies that are there
 * @param camera {@code float[15]}: position, right, up, forward, eye distance, aperture, focus distance
 * @param properties {@code float[12]}
 * @param shadowDisc {@code float[2 * shadowSamples]}: the unit sunflower's points, {@code sqrt(i / n)} from the center
 * @param pixelSamples {@code float[16 * samplesPerPixel]}: the samples' places in a pixel, and numbers for lens and
 *     surfaces
 * @param aspect one of {@link Aspect}'s: what of the picture is drawn
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
