package dev.twister.render;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.Picture;
import dev.twister.world.TonedPixels;
import java.util.Optional;

/**
 * A picture without its background. Samples whose view rays meet nothing count for the alpha of their pixel, and not
 * for its color.
 */
final class Cutout {
    private static final int CHANNELS = 3;
    private static final int ALPHA_SHIFT = 24;
    private static final int OPAQUE = 255;
    private static final int COLOR_MASK = 0xFFFFFF;

    private final float[] radiance;
    private final int[] hits;

    private Cutout(int pixels) {
        radiance = new float[CHANNELS * pixels];
        hits = new int[pixels];
    }

    /**
     * Renders the picture, one sample of each pixel after the other.
     *
     * @param input of the picture itself
     * @param samples number per pixel
     */
    static BandedDrawing.Drawn draw(Engine engine, FrameInput input, int samples, RenderProgress progress) {
        int width = input.width();
        int rows = input.rows();
        Frame colors = Frame.ofRadiance(width, rows);
        Frame bodies = Frame.ofRadiance(width, rows);
        colors.stopWhen(progress::isStopped);
        bodies.stopWhen(progress::isStopped);
        FrameInput shown = input.showing(Picture.BODY);
        Cutout cutout = new Cutout(width * rows);
        FrameTimes times = FrameTimes.NONE;
        for (int sample = 0; sample < samples; sample++) {
            engine.render(shown.withSamples(sample, 1), bodies);
            times = times.plus(bodies.times());
            engine.render(input.withSamples(sample, 1), colors);
            times = times.plus(colors.times());
            cutout.add(colors.radiance(), bodies.radiance());
            progress.part(engine.id(), (sample + 1.0) / samples, Optional.empty());
        }
        Frame whole = Frame.ofPixels(width, rows);
        cutout.put(whole.argb(), samples, input);
        whole.setTimes(times);
        return new BandedDrawing.Drawn(whole, new float[0], 0);
    }

    private void add(float[] colors, float[] bodies) {
        for (int pixel = 0; pixel < hits.length; pixel++) {
            // Bodies have numbers from 0 on.
            if (bodies[CHANNELS * pixel] >= 0) {
                hits[pixel]++;
                for (int value = CHANNELS * pixel; value < CHANNELS * pixel + CHANNELS; value++) {
                    radiance[value] += colors[value];
                }
            }
        }
    }

    private void put(int[] argb, int samples, FrameInput input) {
        for (int value = 0; value < radiance.length; value++) {
            radiance[value] /= Math.max(1, hits[value / CHANNELS]);
        }
        TonedPixels.write(radiance, input, argb);
        for (int pixel = 0; pixel < argb.length; pixel++) {
            int alpha = Math.round((float) OPAQUE * hits[pixel] / samples);
            argb[pixel] = alpha << ALPHA_SHIFT | (argb[pixel] & COLOR_MASK);
        }
    }
}
