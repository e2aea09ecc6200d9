package dev.twister.engine.auto;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.function.Supplier;

/**
 * Draws at once with an engine that needs no warming, and goes over to the one that is to be used as soon as that one,
 * started beside it, is the faster of the two: a JVM compiles the vector engine in seconds, TornadoVM a kernel
 * likewise.
 */
final class AutoEngine implements Engine {
    private final Successor successor;
    private final Supplier<Engine> standIns;
    private volatile Engine current;
    private boolean succeeded;
    private volatile String complaint = "";

    /**
     * Starts nothing but the stand-in's frames; the first of them starts the successor.
     *
     * @param standIn draws until the successor does
     * @param standIns opens another one, which draws from then on where the successor fails
     */
    AutoEngine(Engine standIn, Successor successor, Supplier<Engine> standIns) {
        this.successor = successor;
        this.standIns = standIns;
        current = standIn;
    }

    /** The id of the engine that drew the last frame. */
    @Override
    public String id() {
        return current.id();
    }

    /** Where the engine that was gone over to failed, with what it said. */
    @Override
    public String device() {
        return current.device() + complaint;
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
        draw(input, frame);
        if (!succeeded) {
            double samples = (double) frame.width() * frame.height() * input.samplesPerPixel();
            successor.mustBeat(frame.times().totalNanos(), samples);
        }
    }

    private void draw(FrameInput input, Frame frame) {
        try {
            current.render(input, frame);
        } catch (EngineException failure) {
            if (!succeeded || !complaint.isEmpty()) {
                throw failure;
            }
            Engine standIn = standIns.get();
            complaint = "; " + failure.getMessage();
            current.close();
            current = standIn;
            current.render(input, frame);
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
