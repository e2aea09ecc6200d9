package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.Arrays;

/** Fills pictures with one color and reports fixed frame times. */
public record FakeEngine(String id, int argb, FrameTimes times) implements Engine {
    @Override
    public String device() {
        return "a device of the test's";
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        Arrays.fill(frame.argb(), argb);
        frame.setTimes(times);
    }

    @Override
    public void close() {
        // Nothing to release.
    }
}
