package dev.twister.gui.model;

import dev.twister.image.FrameStop;
import dev.twister.engine.JvmKernel;
import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.world.FrameInput;

/**
 * What there is to know of a pixel.
 *
 * @param x from 0 at the left
 * @param y from 0 at the top
 * @param argb as it is shown
 * @param radiance linear, as the scalar kernel has it from the picture's own samples; the number itself in a view of
 *     numbers
 * @param body what the pixel's center shows, numbered as {@link BodyNumber} does
 * @param distance to it in meters; 0 for the sky
 * @param samples of the pixel
 */
public record PixelReading(int x, int y, int argb, Rgb radiance, int body, double distance, int samples) {
    /** More take longer than one waits, and change no digit that is shown by much. */
    private static final int MOST_SAMPLES = 256;

    /**
     * Reads a pixel; takes as long as its samples take the scalar kernel.
     *
     * @param input of the picture
     * @param samples that the picture has gathered
     * @param argb that the pixel is shown as
     */
    public static PixelReading of(FrameInput input, int samples, int x, int y, int argb) {
        int read = Math.min(samples, MOST_SAMPLES);
        FrameInput sampled = read == input.samplesPerPixel() ? input : input.withSamples(0, read);
        Frame row = Frame.ofRadiance(input.width(), 1);
        new JvmKernel().drawRow(sampled.band(y, 1), FrameStop.of(row), 0, x, x + 1);
        PointerRay ray = PointerRay.through(input, x + 0.5, y + 0.5);
        return new PixelReading(
                x,
                y,
                argb,
                new Rgb(row.radiance()[3 * x], row.radiance()[3 * x + 1], row.radiance()[3 * x + 2]),
                ray.body(),
                ray.body() == Layout.NOTHING ? 0 : ray.distance(),
                samples);
    }
}
