package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;

/** Has not the memory for pictures of a width. */
record GreedyEngine(Engine engine, String id, int width) implements Engine {
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
