package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.Arrays;

/** Compares an engine's picture with {@code sequential}'s. */
final class Pictures {
    /** Transparent, so no rendered pixel equals it. */
    private static final int POISON = 0x00DEAD00;

    private Pictures() {}

    /** Requires a difference of at most 1 of 255 per channel, except at 1 pixel in 5,000. */
    static void requireSequentials(Engine engine, FrameInput input) {
        int pixels = input.width() * input.rows();
        assertThat(differences(engine, input))
                .as("pixels of %d x %d that differ from sequential's", input.width(), input.rows())
                .isLessThanOrEqualTo((pixels + 4999) / 5000);
    }

    /** Counts the pixels with a difference above 1 of 255 in a channel. */
    static int differences(Engine engine, FrameInput input) {
        int[] expected = draw(input);
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        Arrays.fill(frame.argb(), POISON);
        engine.render(input, frame);
        int differences = 0;
        for (int i = 0; i < expected.length; i++) {
            assertThat(frame.argb()[i] >>> 24).as("alpha of pixel %d", i).isEqualTo(0xFF);
            differences += farthestChannel(expected[i], frame.argb()[i]) > 1 ? 1 : 0;
        }
        return differences;
    }

    /** Renders and returns the engine's pixels. */
    static int[] of(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        Arrays.fill(frame.argb(), POISON);
        engine.render(input, frame);
        return frame.argb();
    }

    /** As {@link #requireSequentials} for linear radiance and layers, where 1 of 255 is relative above 1. */
    static void requireSequentialsRadiance(Engine engine, FrameInput input) {
        Frame expected = Frame.ofRadiance(input.width(), input.rows(), input.layers());
        try (Engine sequential = Engines.open("sequential")) {
            sequential.render(input, expected);
        }
        Frame frame = Frame.ofRadiance(input.width(), input.rows(), input.layers());
        Arrays.fill(frame.radiance(), Float.NaN);
        Arrays.fill(frame.layers(), Float.NaN);
        engine.render(input, frame);
        requireAlike(frame.radiance(), expected.radiance());
        requireAlike(frame.layers(), expected.layers());
    }

    private static void requireAlike(float[] values, float[] expected) {
        int differences = 0;
        for (int i = 0; i < expected.length; i++) {
            float right = expected[i];
            assertThat(values[i]).as("channel %d", i).isNotNaN();
            differences += Math.abs(values[i] - right) > Math.max(1, Math.abs(right)) / 255 ? 1 : 0;
        }
        assertThat(differences).isLessThanOrEqualTo((expected.length / 3 + 4999) / 5000);
    }

    private static int[] draw(FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        try (Engine sequential = Engines.open("sequential")) {
            sequential.render(input, frame);
        }
        return frame.argb();
    }

    private static int farthestChannel(int a, int b) {
        int farthest = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            farthest = Math.max(farthest, Math.abs((a >> shift & 0xFF) - (b >> shift & 0xFF)));
        }
        return farthest;
    }
}
