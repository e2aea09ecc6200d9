package dev.twister.engine.auto;

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
 * beats the one that draws. That one must have drawn a few frames by then, or a long one: its first is begun by the
 * JVM's interpreter, which even the vector engine on a CPU without AVX beats.
 */
final class Successor implements AutoCloseable {
    /** Some pictures a second are shown meanwhile. */
    private static final long PAUSE_NANOS = 400_000_000;

    /** How many frames of the engine that draws, its last ones, are to be beaten. */
    private static final int FRAMES_TO_BEAT = 3;

    /** Frames that took so long all together were drawn by compiled code for most of it. */
    private static final long LONG_NANOS = 2_000_000_000;

    /** What a cold JVM takes to compile the vector engine, twice over: frames that are no better then are given up. */
    static final Duration WARMING = Duration.ofSeconds(8);

    private final Function<BooleanSupplier, Optional<Engine>> opener;
    private final Duration patience;
    /**
     * What the last frames of the engine that draws took, in nanoseconds for each sample of a pixel: the scene may
     * change.
     */
    private final double[] nanosToBeat = new double[FRAMES_TO_BEAT];

    private long framesToBeat;
    /** What all frames of the engine that draws took. */
    private long drawnNanos;

    private volatile boolean closed;
    private boolean over;
    private boolean started;
    private volatile Optional<FrameInput> newest = Optional.empty();
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
     * @param patience how long a frame waits for this engine, all frames together: the compiler is done sooner where
     *     not every core draws
     */
    Successor(Function<BooleanSupplier, Optional<Engine>> opener, Duration patience) {
        this.patience = patience;
        this.opener = opener;
    }

    /**
     * Starts, the first time, to open and to warm the engine; from then on what it draws is what is drawn beside it.
     *
     * @param input of the frame that is drawn now
     */
    synchronized void follow(FrameInput input) {
        if (newest.filter(old -> !Work.of(old).equals(Work.of(input))).isPresent()) {
            framesToBeat = 0;
            drawnNanos = 0;
        }
        newest = Optional.of(input);
        if (!started) {
            started = true;
            Thread.ofPlatform().daemon().name("twister-warm-up").start(this::warm);
        }
    }

    /** How long the engine that draws took for a frame, with this number of samples per pixel. */
    synchronized void mustBeat(long nanos, double samples) {
        nanosToBeat[(int) (framesToBeat % FRAMES_TO_BEAT)] = nanos / samples;
        framesToBeat++;
        drawnNanos += nanos;
    }

    /** Where no more frames are drawn, those there are must do for what gets no faster. */
    private synchronized boolean isBeatenBy(double nanosPerSample, boolean settled) {
        int known = (int) Math.min(framesToBeat, FRAMES_TO_BEAT);
        boolean enough = known == FRAMES_TO_BEAT || (known > 0 && (settled || drawnNanos >= LONG_NANOS));
        return enough && Arrays.stream(nanosToBeat, 0, known).allMatch(frame -> nanosPerSample < frame);
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

    /** Whether no engine comes any more. */
    synchronized boolean isOver() {
        return over && ready.isEmpty();
    }

    /** The engine, once it is warm; from then on it is the caller's. */
    synchronized Optional<Engine> take() {
        Optional<Engine> taken = ready;
        ready = Optional.empty();
        if (taken.isPresent()) {
            // Skies are large.
            newest = Optional.empty();
        }
        return taken;
    }

    /** Ends the warming; an engine that nobody took is closed. */
    @Override
    public synchronized void close() {
        closed = true;
        take().ifPresent(Engine::close);
    }

    private void warm() {
        try {
            opener.apply(() -> closed).ifPresent(this::warm);
        } catch (EngineException | OutOfMemoryError _) {
            // The present engine goes on; opening this one by its name says why it failed.
        } finally {
            freeWhoWaits();
        }
    }

    private synchronized void freeWhoWaits() {
        over = true;
        notifyAll();
    }

    private void warm(Engine engine) {
        boolean warm = false;
        try {
            Trial trial = new Trial(engine, newest.orElseThrow());
            boolean again = true;
            while (!warm && !closed && (again || !trial.isHopeless())) {
                FrameInput now = newest.orElseThrow();
                if (!Work.of(now).equals(trial.work)) {
                    trial = new Trial(engine, now);
                } else if (trial.isHopeless()) {
                    // The camera may look at what takes another time: one more trial of what it sees now.
                    again = false;
                    trial = new Trial(engine, now);
                }
                warm = isBeatenBy(trial.draw(), trial.frames.areSettled());
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

    /** What, beside the view, decides how long a pixel's sample takes: times of one tell nothing of another. */
    private record Work(int room, int shadowSamples, int bounces) {
        static Work of(FrameInput input) {
            return new Work(input.bodies().room(), input.shadowSamples(), input.bounces());
        }
    }

    /** Small pictures of one input. */
    private static final class Trial {
        private final Work work;
        private final SettlingFrames frames;
        private final double samples;
        private long spentNanos;

        Trial(Engine engine, FrameInput input) {
            FrameInput small = SettlingFrames.small(input);
            work = Work.of(input);
            frames = new SettlingFrames(engine, small);
            samples = (double) small.width() * small.rows() * small.samplesPerPixel();
        }

        /** Draws one; returns the nanoseconds for each sample of its pixels. */
        double draw() {
            long nanos = frames.draw().toNanos();
            spentNanos += nanos;
            return nanos / samples;
        }

        boolean isHopeless() {
            return frames.areSettled() && spentNanos > WARMING.toNanos();
        }
    }
}
