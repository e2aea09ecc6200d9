package dev.twister.render;

import dev.twister.engine.ConvergingPicture;
import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import java.util.Optional;

/**
 * The samples of a picture's pixels.
 *
 * @param samples of each pixel; the limit where there is a bound of the noise
 * @param noise as a share of white
 */
public record Sampling(int samples, Optional<Double> noise) {
    /** Fewer do not show how noisy a picture is. */
    public static final int LEAST_CONVERGING = 8;

    /** The largest number of samples per pixel. */
    public static final int MOST = 65536;

    /** In one call of an engine. */
    public int atOnce() {
        return Math.min(samples, Rendering.MAX_SAMPLES_PER_PIXEL);
    }

    /**
     * Draws a band.
     *
     * @param input with {@link #atOnce} samples, where there is no bound of the noise
     * @return the samples of each pixel
     */
    int draw(Engine engine, FrameInput input, Frame frame) {
        if (noise.isPresent() || samples > atOnce()) {
            return ConvergingPicture.draw(engine, input, frame, noise.orElse(0.0), samples);
        }
        engine.render(input, frame);
        return samples;
    }

    /** Of which a band's size is chosen. */
    int usual() {
        return noise.isPresent() ? 2 * LEAST_CONVERGING : samples;
    }

    /** In one word or a few, as files keep it. */
    String text() {
        return noise.map(bound -> "noise " + bound + " at most " + samples).orElse(Integer.toString(samples));
    }
}
