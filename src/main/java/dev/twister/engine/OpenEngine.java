package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.FrameInput;

/** An engine that refuses to render once it is closed. */
final class OpenEngine implements Engine {
    private final Engine engine;
    private volatile boolean closed;

    OpenEngine(Engine engine) {
        this.engine = engine;
    }

    @Override
    public String id() {
        return engine.id();
    }

    @Override
    public String device() {
        return engine.device();
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        if (closed) {
            throw new IllegalStateException("engine " + id() + " is closed");
        }
        engine.render(input, frame);
    }

    @Override
    public void onFaster(Runnable listener) {
        engine.onFaster(listener);
    }

    @Override
    public boolean drawsBandsInProportion() {
        return engine.drawsBandsInProportion();
    }

    @Override
    public boolean declines(FrameInput input) {
        return engine.declines(input);
    }

    @Override
    public void rest() {
        engine.rest();
    }

    @Override
    public void close() {
        closed = true;
        engine.close();
    }
}
