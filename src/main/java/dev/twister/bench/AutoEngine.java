package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;

/**
 * Draws at once with an engine that needs no warming, and goes over to the one that is to be used as soon as that one,
 * started beside it, is the faster of the two: a JVM compiles the vector engine in seconds, TornadoVM a kernel likewise.
 */
final class AutoEngine implements Engine {
    private final Successor successor;
    private volatile Engine current;
    private boolean succeeded;

    /**
     * Starts nothing but the stand-in's frames; the first of them starts the successor.
     *
     * @param standIn draws until the successor does
     */
    AutoEngine(Engine standIn, Successor successor) {
        this.successor = successor;
        current = standIn;
    }

    /** The id of the engine that drew the last frame. */
    @Override
    public String id() {
        return current.id();
    }

    @Override
    public String device() {
        return current.device();
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        if (!succeeded) {
            successor.await();
            successor.take().ifPresent(this::goOverTo);
        }
        if (!succeeded) {
            successor.follow(input);
        }
        current.render(input, frame);
        if (!succeeded) {
            double samples = (double) frame.width() * frame.height() * input.samplesPerPixel();
            successor.mustBeat(frame.times().totalNanos() / samples);
        }
    }

    @Override
    public void onFaster(Runnable listener) {
        successor.onReady(listener);
        current.onFaster(listener);
    }

    /** While frames are measured, they are whole. */
    @Override
    public boolean drawsBandsInProportion() {
        return (succeeded || successor.isOver()) && current.drawsBandsInProportion();
    }

    @Override
    public void rest() {
        current.rest();
    }

    private void goOverTo(Engine faster) {
        current.close();
        current = faster;
        succeeded = true;
    }

    @Override
    public void close() {
        successor.close();
        current.close();
    }
}
