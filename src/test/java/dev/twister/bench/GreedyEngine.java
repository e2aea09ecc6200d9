package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;

/** Runs out of memory for pictures of one width. */
public record GreedyEngine(Engine engine, String id, int width) implements Engine {
    @Override
    public String device() {
        return engine.device();
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        if (input.width() == width) {
            throw new OutOfMemoryError("Java heap space");
        }
        engine.render(input, frame);
    }

    @Override
    public void close() {
        engine.close();
    }
}
