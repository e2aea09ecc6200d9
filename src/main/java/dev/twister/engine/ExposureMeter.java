package dev.twister.engine;

import dev.twister.image.AlphaChannel;
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

    /**
     * See {@link AutoExposure#stops}: of the whole picture, even where the input is of some of its rows. A background
     * that is not in the picture does not count.
     */
    public static OptionalDouble stops(FrameInput input) {
        double scale = Math.min(1, (double) LONGER_SIDE / Math.max(input.width(), input.height()));
        int width = (int) Math.max(1, Math.round(input.width() * scale));
        int height = (int) Math.max(1, Math.round(input.height() * scale));
        try (Engine engine = JvmEngines.parallel().opener().get()) {
            Frame frame = Frame.ofRadiance(width, height, input.layers());
            engine.render(input.withSize(width, height).withSamples(0, SAMPLES), frame);
            float[] seen = input.isCut() ? AlphaChannel.of(frame).straight(frame.radiance()) : frame.radiance();
            return AutoExposure.stops(seen, input.srgb());
        }
    }
}
