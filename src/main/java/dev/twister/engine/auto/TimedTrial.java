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

/** Renders small frames of the default scene until their time settles, and returns the fastest. */
final class TimedTrial implements FastestEngine.Trial {
    /** Small, because an engine may be hundreds of times slower before its code is compiled. */
    private static final int WIDTH = 192;

    private static final int HEIGHT = 108;
    private static final long LOOK_MILLIS = 20;

    private final FrameInput input = SampleWorld.ofSize(WIDTH, HEIGHT).snapshot();

    /**
     * Renders on a separate thread, because TornadoVM's first frame takes seconds and cannot be interrupted. That
     * thread ends by itself.
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
            // A failed engine is not the fastest; opening it by its name reports the failure.
            best.forget();
        }
    }
}
