package dev.twister.engine.auto;

import dev.twister.engine.BestTime;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.SettlingFrames;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;

/** Draws a small picture of the default kind until its frames get no faster, and takes the fastest. */
final class TimedTrial implements FastestEngine.Trial {
    /** Small, because the frames of a JVM that has compiled nothing yet are hundreds of times slower. */
    private static final int WIDTH = 192;

    private static final int HEIGHT = 108;
    private static final long LOOK_MILLIS = 20;

    private final FrameInput input = SampleWorld.ofSize(WIDTH, HEIGHT).snapshot();

    /**
     * The frames are drawn on a thread of their own, because TornadoVM's first frame takes seconds and cannot be
     * stopped: it is left to end by itself.
     */
    @Override
    public Optional<Duration> frameTime(EngineOffer offer, Duration limit, BooleanSupplier canceled) {
        BestTime best = new BestTime();
        AtomicBoolean over = new AtomicBoolean();
        CountDownLatch done = new CountDownLatch(1);
        Thread.ofPlatform().daemon().name("trial of " + offer.id()).start(() -> {
            try {
                draw(offer, best, () -> over.get() || canceled.getAsBoolean());
            } finally {
                done.countDown();
            }
        });
        try {
            long end = System.nanoTime() + limit.toNanos();
            boolean ended = false;
            while (!ended && System.nanoTime() < end && !canceled.getAsBoolean()) {
                ended = done.await(LOOK_MILLIS, TimeUnit.MILLISECONDS);
            }
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        } finally {
            over.set(true);
        }
        return best.found();
    }

    private void draw(EngineOffer offer, BestTime best, BooleanSupplier over) {
        try (Engine engine = offer.opener().get()) {
            SettlingFrames frames = new SettlingFrames(engine, input, best);
            while (!over.getAsBoolean() && !frames.areSettled()) {
                frames.draw();
            }
        } catch (EngineException | OutOfMemoryError _) {
            // An engine that fails is not the fastest; opening it by its name says why.
            best.forget();
        }
    }
}
