package dev.twister.gui.drawing;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.nio.IntBuffer;
import java.util.concurrent.TimeUnit;

/**
 * The samples of a small path-traced picture that is shown until the full one is drawn: one sample is noise, a few are
 * a picture. Used by one thread.
 */
final class CoarsePicture {
    private static final int MOST_SAMPLES = 8;

    /** From the first sample on. */
    private static final long MOST_NANOS = TimeUnit.MILLISECONDS.toNanos(300);

    private final FrameInput input;
    private final RefinedPicture gathered;
    private final Frame pass;
    private final long startNanos;

    /** @param input of the small size, with one sample per pixel */
    CoarsePicture(FrameInput input, long startNanos) {
        this.input = input;
        this.startNanos = startNanos;
        gathered = new RefinedPicture(input.width(), input.height(), MOST_SAMPLES, false);
        pass = Frame.ofRadiance(input.width(), input.height());
    }

    FrameInput input() {
        return input;
    }

    int samples() {
        return gathered.samples();
    }

    /** Whether it is not worth another sample. */
    boolean isDone(long nanos) {
        return gathered.isDone() || nanos - startNanos > MOST_NANOS;
    }

    /** Adds one sample per pixel and shows all of them. */
    void refine(Engine engine, Frame shown) {
        engine.render(gathered.next(input, 1), pass);
        gathered.add(pass, 1);
        gathered.show(input, IntBuffer.wrap(shown.argb()));
        shown.setTimes(pass.times());
    }
}
