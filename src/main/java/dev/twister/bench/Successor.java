package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.SettlingFrames;
import dev.twister.world.FrameInput;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Function;

/**
 * An engine that is opened and warmed on a thread of its own, with small pictures of what is drawn meanwhile, until it
 * beats the one that draws. That one must have drawn a few frames by then: its first is the JVM's interpreter's, which
 * even the vector engine on a CPU without AVX beats.
 */
final class Successor implements AutoCloseable {
    /** Some pictures a second are shown meanwhile. */
    private static final long PAUSE_NANOS = 400_000_000;

    /** How many frames of the engine that draws, its last ones, are to be beaten. */
    private static final int FRAMES_TO_BEAT = 3;

    /** What a cold JVM takes to compile the vector engine, twice over: frames that are no better then are given up. */
    static final Duration WARMING = Duration.ofSeconds(8);

    private final Function<BooleanSupplier, Optional<Engine>> opener;
    private final Duration patience;
    /** What the last frames of the engine that draws took, in nanoseconds a pixel: the scene may change. */
    private final double[] nanosToBeat = new double[FRAMES_TO_BEAT];

    private long framesToBeat;
    private volatile boolean closed;
    private boolean over;
    private boolean started;
    private long waitedNanos;
    private Optional<Engine> ready = Optional.empty();
    private Runnable listener = () -> {};

    /**
     * Starts nothing.
     *
     * @param opener may take its time, and is told when nobody waits for it any more; empty where the engine that draws
     *     already is to stay
     */
    Successor(Function<BooleanSupplier, Optional<Engine>> opener) {
        this(opener, Duration.ZERO);
    }

    /**
     * Starts nothing.
     *
     * @param patience how long a frame waits for this engine, all frames together: the compiler is done sooner where not
     *     every core draws
     */
    Successor(Function<BooleanSupplier, Optional<Engine>> opener, Duration patience) {
        this.patience = patience;
        this.opener = opener;
    }

    /** Starts, the first time, to open and to warm the engine. */
    void startWith(FrameInput input) {
        if (!started) {
            started = true;
            FrameInput small = SettlingFrames.small(input);
            Thread.ofPlatform().daemon().name("twister-warm-up").start(() -> warm(small));
        }
    }

    /** How long the engine that draws took for a pixel of a frame. */
    synchronized void mustBeat(double nanosPerPixel) {
        nanosToBeat[(int) (framesToBeat % FRAMES_TO_BEAT)] = nanosPerPixel;
        framesToBeat++;
    }

    /** Where no more frames are drawn, those there are must do for what gets no faster. */
    private synchronized boolean isBeatenBy(double nanosPerPixel, boolean settled) {
        int known = (int) Math.min(framesToBeat, FRAMES_TO_BEAT);
        boolean enough = known == FRAMES_TO_BEAT || (known > 0 && settled);
        return enough && Arrays.stream(nanosToBeat, 0, known).allMatch(frame -> nanosPerPixel < frame);
    }

    /** Has someone told, on another thread, when there is an engine to take; at once where there is one. */
    synchronized void onReady(Runnable newListener) {
        listener = newListener;
        if (ready.isPresent()) {
            listener.run();
        }
    }

    /** Waits for the engine a little, where there is patience left. */
    synchronized void await() {
        long start = System.nanoTime();
        long pauseNanos = started ? Math.min(PAUSE_NANOS, patience.toNanos() - waitedNanos) : 0;
        try {
            long leftNanos = pauseNanos;
            while (ready.isEmpty() && !over && !closed && leftNanos > 0) {
                TimeUnit.NANOSECONDS.timedWait(this, leftNanos);
                leftNanos = pauseNanos - (System.nanoTime() - start);
            }
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
        waitedNanos += System.nanoTime() - start;
    }

    /** The engine, once it is warm; from then on it is the caller's. */
    synchronized Optional<Engine> take() {
        Optional<Engine> taken = ready;
        ready = Optional.empty();
        return taken;
    }

    /** Ends the warming; an engine that nobody took is closed. */
    @Override
    public synchronized void close() {
        closed = true;
        take().ifPresent(Engine::close);
    }

    private void warm(FrameInput small) {
        try {
            Optional<Engine> opened = opener.apply(() -> closed);
            if (opened.isPresent()) {
                warm(opened.get(), small);
            }
        } catch (EngineException _) {
            // What draws now goes on; whoever opens the engine by its name is told why.
        } finally {
            freeWhoWaits();
        }
    }

    private synchronized void freeWhoWaits() {
        over = true;
        notifyAll();
    }

    private void warm(Engine engine, FrameInput small) {
        boolean warm = false;
        try {
            SettlingFrames frames = new SettlingFrames(engine, small);
            double pixels = (double) small.width() * small.rows();
            long spentNanos = 0;
            while (!warm && !closed && !(frames.areSettled() && spentNanos > WARMING.toNanos())) {
                long nanos = frames.draw().toNanos();
                spentNanos += nanos;
                warm = isBeatenBy(nanos / pixels, frames.areSettled());
            }
        } finally {
            if (!warm) {
                engine.close();
            }
        }
        if (warm) {
            offer(engine);
        }
    }

    private synchronized void offer(Engine engine) {
        if (closed) {
            engine.close();
        } else {
            ready = Optional.of(engine);
            notifyAll();
            listener.run();
        }
    }
}
