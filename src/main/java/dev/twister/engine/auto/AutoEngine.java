package dev.twister.engine.auto;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.function.Supplier;

/**
 * Renders at once with an engine that needs no warm-up, the stand-in. It switches to the successor as soon as that one,
 * started in the background, is faster. The vector engine and a TornadoVM kernel each take seconds to compile.
 */
final class AutoEngine implements Engine {
    private final Successor successor;
    private final Supplier<Engine> standIns;
    private volatile Engine current;
    private boolean succeeded;
    private volatile String complaint = "";

    /**
     * Starts nothing yet; the first frame starts the successor.
     *
     * @param standIn renders until the successor does
     * @param standIns opens a new stand-in for the case that the successor fails later
     */
    AutoEngine(Engine standIn, Successor successor, Supplier<Engine> standIns) {
        this.successor = successor;
        this.standIns = standIns;
        current = standIn;
    }

    /** The id of the engine that rendered the last frame. */
    @Override
    public String id() {
        return current.id();
    }

    /** The current engine's device, followed by the message of a failed successor. */
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
        draw(input, frame);
        if (!succeeded) {
            // Not before the first frame, which may be the only one.
            successor.follow(input);
            double samples = (double) frame.width() * frame.height() * input.samplesPerPixel();
            successor.mustBeat(frame.times().effortNanos(), samples);
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

    /** False while frames are measured, because measured frames must be whole. */
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
