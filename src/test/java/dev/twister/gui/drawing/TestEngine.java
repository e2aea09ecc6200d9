package dev.twister.gui.drawing;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/** An engine of one color, of which one can see how many are open, and which one can hold up or break. */
final class TestEngine implements Engine {
    private static final int ANY_NUMBER = 1_000_000_000;

    private final Kind kind;
    private final AtomicReference<Thread> user = new AtomicReference<>();
    private volatile Look look;

    private TestEngine(Kind kind) {
        this.kind = kind;
        look = kind.look;
    }

    /** What it is called and what it draws. */
    record Look(String id, int color) {}

    /** All engines of one name. */
    static final class Kind {
        private volatile Look look;
        final AtomicInteger alive = new AtomicInteger();
        final AtomicInteger opened = new AtomicInteger();
        final AtomicInteger frames = new AtomicInteger();
        final AtomicInteger rests = new AtomicInteger();
        final AtomicInteger framesBeforeRest = new AtomicInteger();
        volatile boolean breaks;
        volatile Runnable onFaster = () -> {};
        volatile Runnable onFrame = () -> {};
        private final Semaphore gate = new Semaphore(ANY_NUMBER);

        Kind(String id, int color) {
            look = new Look(id, color);
        }

        String id() {
            return look.id();
        }

        /** Has every engine of this kind become another one within its next frame, which is drawn by that. */
        void become(String id, int color) {
            look = new Look(id, color);
        }

        /** From now on frames wait. */
        void hold() {
            gate.drainPermits();
        }

        /** Whether a frame waits. */
        boolean isWaitedFor() {
            return gate.hasQueuedThreads();
        }

        /** Lets so many frames pass. */
        void allow(int number) {
            gate.release(number);
        }

        void allowAll() {
            hold();
            allow(ANY_NUMBER);
        }

        EngineOffer offer() {
            return EngineOffer.working(look.id(), "a test", "one color", () -> {
                alive.incrementAndGet();
                opened.incrementAndGet();
                return new TestEngine(this);
            });
        }
    }

    @Override
    public String id() {
        return look.id();
    }

    @Override
    public String device() {
        return "a test";
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        if (!user.compareAndSet(null, Thread.currentThread())) {
            throw new AssertionError("used by two threads at once");
        }
        kind.gate.acquireUninterruptibly();
        kind.frames.incrementAndGet();
        kind.onFrame.run();
        user.set(null);
        look = kind.look;
        if (kind.breaks) {
            throw new EngineException(look.id() + " broke");
        }
        Arrays.fill(frame.argb(), look.color());
        Arrays.fill(frame.radiance(), 1);
        frame.setTimes(FrameTimes.onJvm(1));
    }

    @Override
    public void onFaster(Runnable listener) {
        kind.onFaster = listener;
    }

    @Override
    public void rest() {
        kind.framesBeforeRest.set(kind.frames.get());
        kind.rests.incrementAndGet();
    }

    @Override
    public boolean drawsBandsInProportion() {
        return true;
    }

    @Override
    public void close() {
        kind.alive.decrementAndGet();
    }
}
