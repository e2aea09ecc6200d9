package dev.twister.gui.picture;

import dev.twister.engine.Engine;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.studio.Studio;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

/**
 * The linear radiance of the picture that is shown.
 *
 * @param gathered by the window's engine; empty if it has gone on to another picture
 */
public record ShownRadiance(int width, int height, FrameInput input, CompletableFuture<Optional<float[]>> gathered) {
    /** Of the present picture. */
    public static ShownRadiance of(Studio studio, DrawnPicture shown) {
        // What is seen as one samples it: the frame's own samples, or those gathered since.
        FrameInput own = shown.input();
        int samples = shown.samples();
        FrameInput input = samples == own.samplesPerPixel() ? own : own.withSamples(0, samples);
        return new ShownRadiance(shown.frame().width(), shown.frame().height(), input, studio.radiance(shown));
    }

    /** Waits for it, or renders the same picture if the window's engine is busy with another one. */
    public float[] await() {
        return gathered.join().orElseGet(this::draw);
    }

    private float[] draw() {
        Frame linear = Frame.ofRadiance(width, height);
        try (Engine engine = JvmEngines.parallel().opener().get()) {
            engine.render(input, linear);
        }
        return linear.radiance();
    }
}
