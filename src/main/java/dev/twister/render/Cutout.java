package dev.twister.render;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
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
     * Renders the picture.
     *
     * @param input of the picture itself
     * @param samples number per pixel
     */
    static BandedDrawing.Drawn draw(Engine engine, FrameInput input, int samples, RenderProgress progress) {
        Cutout cutout = new Cutout(input.width() * input.rows());
        FrameTimes times = cutout.gather(engine, input, samples, progress);
        Frame whole = Frame.ofPixels(input.width(), input.rows());
        cutout.put(whole.argb(), samples, input);
        whole.setTimes(times);
        return new BandedDrawing.Drawn(whole, new float[0], 0);
    }

    /**
     * The mean linear radiance of the samples of each pixel that meet a body, three floats a pixel; 0 where none does.
     */
    static float[] radiance(Engine engine, FrameInput input, int samples) {
        Cutout cutout = new Cutout(input.width() * input.rows());
        FrameTimes _ = cutout.gather(engine, input, samples, RenderProgress.SILENT);
        return cutout.radiance;
    }

    /** Renders one sample of each pixel after the other. */
    private FrameTimes gather(Engine engine, FrameInput input, int samples, RenderProgress progress) {
        Frame colors = Frame.ofRadiance(input.width(), input.rows());
        Frame bodies = Frame.ofRadiance(input.width(), input.rows());
        colors.stopWhen(progress::isStopped);
        bodies.stopWhen(progress::isStopped);
        FrameInput shown = input.showing(StageOrView.BODY);
        FrameTimes times = FrameTimes.NONE;
        for (int sample = 0; sample < samples; sample++) {
            engine.render(shown.withSamples(sample, 1), bodies);
            times = times.plus(bodies.times());
            engine.render(input.withSamples(sample, 1), colors);
            times = times.plus(colors.times());
            add(colors.radiance(), bodies.radiance());
            progress.part(engine.id(), (sample + 1.0) / samples, Optional.empty());
        }
        for (int value = 0; value < radiance.length; value++) {
            radiance[value] /= Math.max(1, hits[value / CHANNELS]);
        }
        return times;
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
        TonedPixels.write(radiance, input, argb);
        for (int pixel = 0; pixel < argb.length; pixel++) {
            int alpha = Math.round((float) OPAQUE * hits[pixel] / samples);
            argb[pixel] = alpha << ALPHA_SHIFT | (argb[pixel] & COLOR_MASK);
        }
    }
}
