package dev.twister.gui.picture;

import dev.twister.engine.JvmKernel;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.picking.PointerRay;
import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import java.util.Locale;

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

    /**
     * What the inspector says of the
     *
     * @param sceneBody the body of the pixel, as the scene numbers it
     */
    String text(int sceneBody, StageOrView shown) {
        return String.format(
                Locale.ROOT,
                "x %d   y %d   RGB %d %d %d   #%06X%n%s%n%s   %d %s",
                x,
                y,
                argb >> 16 & 255,
                argb >> 8 & 255,
                argb & 255,
                argb & 0xFFFFFF,
                value(radiance, shown),
                sceneBody == BodyNumber.NONE
                        ? "sky"
                        : String.format(Locale.ROOT, "%s, %.3f m away", bodyName(sceneBody), distance),
                samples,
                samples == 1 ? "sample" : "samples");
    }

    /** A body as the scene numbers it. */
    static String bodyName(int body) {
        if (BodyNumber.mesh(body) < 0 && BodyNumber.light(body) > 0) {
            return "light " + (BodyNumber.light(body) + 1);
        }
        return switch (body) {
            case BodyNumber.NONE -> "sky";
            case BodyNumber.LIGHT -> "light";
            case BodyNumber.PLANE -> "plane";
            default ->
                BodyNumber.mesh(body) >= 0
                        ? "mesh " + (BodyNumber.mesh(body) + 1)
                        : "sphere " + (BodyNumber.sphere(body) + 1);
        };
    }

    private static String value(Rgb value, StageOrView shown) {
        String name = shown.isColor() ? "radiance" : shown.id();
        return shown.isNumber()
                ? String.format(Locale.ROOT, "%s %.5g", name, value.red())
                : String.format(Locale.ROOT, "%s %.5f %.5f %.5f", name, value.red(), value.green(), value.blue());
    }
}
