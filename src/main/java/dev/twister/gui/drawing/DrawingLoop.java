package dev.twister.gui.drawing;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Draws one picture after the other on a thread of its own, always by the newest request. Whoever asks and shows never waits:
 * {@link #request} and {@link #takeNewest} return at once.
 */
public final class DrawingLoop implements AutoCloseable {
    private final PictureExchange exchange = new PictureExchange();
    private final LivingWorld world;
    private final EngineSeat seat;
    private final Thread thread;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private Optional<DrawingRequest> newest = Optional.empty();
    private boolean closed;
    private volatile DrawingStatus status = DrawingStatus.QUIET;
    private long pictures;

    /**
     * Starts the thread, which waits for a request.
     *
     * @param skies where panoramas come from
     * @param substitute the engine that draws until the chosen one is ready, and where that fails; must open at once
     */
    public DrawingLoop(SkyShelf skies, EngineOffer substitute) {
        world = new LivingWorld(skies);
        seat = new EngineSeat(substitute);
        thread = Thread.ofPlatform().daemon().name("drawing").unstarted(this::run);
    }

    public void start() {
        thread.start();
    }

    /** From the next picture on, this is what is drawn. */
    public void request(DrawingRequest request) {
        lock.lock();
        try {
            newest = Optional.of(request);
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** See {@link PictureExchange#takeNewest}. */
    public Optional<DrawnPicture> takeNewest() {
        return exchange.takeNewest();
    }

    public DrawingStatus status() {
        return status;
    }

    /** Lets the thread end after the picture it is at, and close its engine; does not wait for it. */
    @Override
    public void close() {
        lock.lock();
        try {
            closed = true;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** Waits for the thread to end; whether it did. */
    public boolean awaitEnd(Duration limit) throws InterruptedException {
        return thread.join(limit);
    }

    private void run() {
        try (seat) {
            long answered = Long.MIN_VALUE;
            Optional<DrawingRequest> next = await(answered);
            while (next.isPresent()) {
                answered = draw(next.get()) ? next.get().number() : answered;
                next = await(answered);
            }
        }
    }

    /** The newest request, once there is something to draw by it; empty when the loop is closed. */
    private Optional<DrawingRequest> await(long answered) {
        lock.lock();
        try {
            while (!closed && newest.filter(request -> isDue(request, answered)).isEmpty()) {
                changed.awaitUninterruptibly();
            }
            return closed ? Optional.empty() : newest;
        } finally {
            lock.unlock();
        }
    }

    private static boolean isDue(DrawingRequest request, long answered) {
        return !request.restful() || request.number() != answered;
    }

    /** Whether the request has been answered by the engine it asks for, or cannot be. */
    private boolean draw(DrawingRequest request) {
        FrameInput input = world.snapshot(request);
        Engine engine = seat.engineFor(request.engine(), input);
        status = new DrawingStatus(seat.opening(), seat.failure(), world.complaint());
        Frame frame = exchange.frameToDraw(request.width(), request.height());
        try {
            engine.render(input, frame);
        } catch (RuntimeException | Error problem) {
            exchange.abandon(frame);
            seat.giveUp(EngineSeat.explain(request.engine().offer(), problem));
            return false;
        }
        pictures++;
        exchange.finished(new DrawnPicture(
                frame, request, input, engine.id(), engine.device(), frame.times(), pictures, System.nanoTime()));
        return seat.opening().isEmpty();
    }
}
