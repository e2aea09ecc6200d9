package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.OptionalDouble;

/**
 * Measures the exposure of a picture before it is drawn, by a small one of it, always by the kernel itself: every part
 * of a film gets the same number on every machine.
 */
public final class ExposureMeter {
    private static final int LONGER_SIDE = 256;
    private static final int SAMPLES = 4;

    private ExposureMeter() {}

    /** Draws a picture: its linear radiance, three floats a pixel. */
    public interface Drawing {
        float[] radiance(Engine engine, FrameInput input, int samples);
    }

    /** See {@link AutoExposure#stops}: of the whole picture, even where the input is of some of its rows. */
    public static OptionalDouble stops(FrameInput input) {
        return stops(input, (engine, small, samples) -> {
            Frame frame = Frame.ofRadiance(small.width(), small.rows());
            engine.render(small.withSamples(0, samples), frame);
            return frame.radiance();
        });
    }

    /** As above, of what the caller draws. */
    public static OptionalDouble stops(FrameInput input, Drawing drawing) {
        double scale = Math.min(1, (double) LONGER_SIDE / Math.max(input.width(), input.height()));
        int width = (int) Math.max(1, Math.round(input.width() * scale));
        int height = (int) Math.max(1, Math.round(input.height() * scale));
        try (Engine engine = JvmEngines.parallel().opener().get()) {
            return AutoExposure.stops(drawing.radiance(engine, input.withSize(width, height), SAMPLES), input.srgb());
        }
    }
}
