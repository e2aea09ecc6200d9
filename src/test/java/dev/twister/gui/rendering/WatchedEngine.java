package dev.twister.gui.rendering;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;

/** Renders gray frames, and tells before each how many there were. */
record WatchedEngine(AtomicInteger frames, IntConsumer watcher) implements Engine {
    static EngineOffer offer(IntConsumer watcher) {
        return EngineOffer.working("watched", "a test", "gray", () -> new WatchedEngine(new AtomicInteger(), watcher));
    }

    @Override
    public String id() {
        return "watched";
    }

    @Override
    public String device() {
        return "a test";
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        watcher.accept(frames.getAndIncrement());
        Arrays.fill(frame.argb(), 0xff808080);
    }

    @Override
    public void close() {
        // Holds nothing.
    }
}
