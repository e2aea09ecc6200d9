package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;

/** Draws a small picture of the default kind for as long as it may, and takes the fastest frame. */
final class TimedTrial implements EngineTrial {
    /** Small, because the frames of a JVM that has compiled nothing yet are hundreds of times slower. */
    private static final int WIDTH = 192;

    private static final int HEIGHT = 108;
    private static final long NONE = Long.MAX_VALUE;

    private final FrameInput input = SampleWorld.ofSize(WIDTH, HEIGHT).snapshot();

    /**
     * The frames are drawn on a thread of their own, because TornadoVM's first frame takes seconds and cannot be
     * stopped: it is left to end by itself.
     */
    @Override
    public Optional<Duration> frameTime(EngineOffer offer, Duration limit) {
        AtomicLong best = new AtomicLong(NONE);
        AtomicBoolean over = new AtomicBoolean();
        CountDownLatch done = new CountDownLatch(1);
        Thread.ofPlatform().daemon().name("trial of " + offer.id()).start(() -> {
            try {
                draw(offer, best, over);
            } finally {
                done.countDown();
            }
        });
        try {
            if (done.await(limit.toNanos(), TimeUnit.NANOSECONDS)) {
                // It failed: a trial that works goes on until it is told to stop.
                return Optional.empty();
            }
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        } finally {
            over.set(true);
        }
        return best.get() == NONE ? Optional.empty() : Optional.of(Duration.ofNanos(best.get()));
    }

    private void draw(EngineOffer offer, AtomicLong best, AtomicBoolean over) {
        Frame frame = Frame.ofPixels(WIDTH, HEIGHT);
        try (Engine engine = offer.opener().get()) {
            while (!over.get()) {
                engine.render(input, frame);
                best.accumulateAndGet(frame.times().totalNanos(), Math::min);
            }
        } catch (EngineException _) {
            // An engine that fails is not the fastest; whoever opens it by its name is told why.
        }
    }
}
