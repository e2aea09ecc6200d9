package dev.twister.engine.auto;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.SettlingFrames;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Function;

/**
 * Opens and warms up an engine on its own thread, with small frames of the current input, until it is faster than the
 * current engine. The current engine must have rendered a few frames by then, or a long one: its first frame starts in
 * the interpreter and is slower than even the vector engine on a CPU without AVX.
 */
final class Successor implements AutoCloseable {
    /** Longest pause per frame; leaves a few frames per second. */
    private static final long PAUSE_NANOS = 400_000_000;

    /** Number of the current engine's latest frames to beat. */
    private static final int FRAMES_TO_BEAT = 3;

    /** Frames that took longer in total were mostly rendered by compiled code. */
    private static final long LONG_NANOS = 2_000_000_000;

    /**
     * Twice the time that a cold JVM takes to compile the vector engine; settled trials that are slower after this time
     * end.
     */
    static final Duration WARMING = Duration.ofSeconds(8);

    private final Function<BooleanSupplier, Optional<Engine>> opener;
    private final Duration patience;
    /**
     * Nanoseconds per pixel sample of the current engine's latest frames. Only these are compared, because the scene
     * may change.
     */
    private final double[] nanosToBeat = new double[FRAMES_TO_BEAT];

    private long framesToBeat;
    /** Total time of the current engine's frames. */
    private long drawnNanos;

    private volatile boolean closed;
    private boolean over;
    private boolean started;
    /** Whether the engine waits for a frame that it would not leave to the kernel. */
    private boolean declines;

    private volatile Optional<FrameInput> newest = Optional.empty();
    private long waitedNanos;
    private Optional<Engine> ready = Optional.empty();
    private Runnable listener = () -> {};

    /**
     * Starts nothing yet.
     *
     * @param opener opens the engine; may take long, and is told when its result is no longer needed. Empty if the
     *     current engine is to stay.
     */
    Successor(Function<BooleanSupplier, Optional<Engine>> opener) {
        this(opener, Duration.ZERO);
    }

    /**
     * Starts nothing yet.
     *
     * @param patience how long frames may wait for this engine in total: JIT compilation finishes earlier while not all
     *     cores render
     */
    Successor(Function<BooleanSupplier, Optional<Engine>> opener, Duration patience) {
        this.patience = patience;
        this.opener = opener;
    }

    /**
     * The first call starts to open and warm up the engine. Its trial frames follow the latest input.
     *
     * @param input the input of the current engine's frame
     */
    synchronized void follow(FrameInput input) {
        if (newest.filter(old -> !Rows.of(old).equals(Rows.of(input))).isPresent()) {
            framesToBeat = 0;
        }
        if (newest.filter(old -> !Work.of(old).equals(Work.of(input))).isPresent()) {
            framesToBeat = 0;
            drawnNanos = 0;
        }
        newest = Optional.of(input);
        notifyAll();
        if (!started) {
            started = true;
            Thread.ofPlatform().daemon().name("twister-warm-up").start(this::warm);
        }
    }

    /** Records a frame's time, see {@link FrameTimes#effortNanos}, and its number of pixel samples. */
    synchronized void mustBeat(long nanos, double samples) {
        nanosToBeat[(int) (framesToBeat % FRAMES_TO_BEAT)] = nanos / samples;
        framesToBeat++;
        drawnNanos += nanos;
        notifyAll();
    }

    /** With fewer frames than required, a settled or long series is enough. */
    private synchronized boolean isBeatenBy(double nanosPerSample, boolean settled) {
        int known = (int) Math.min(framesToBeat, FRAMES_TO_BEAT);
        boolean enough = known == FRAMES_TO_BEAT || (known > 0 && (settled || drawnNanos >= LONG_NANOS));
        return enough && Arrays.stream(nanosToBeat, 0, known).allMatch(frame -> nanosPerSample < frame);
    }

    /** Sets a listener for when the engine is ready, which is called on another thread; at once if it already is. */
    synchronized void onReady(Runnable newListener) {
        listener = newListener;
        if (ready.isPresent()) {
            listener.run();
        }
    }

    /** Waits briefly for the engine, while patience is left. */
    synchronized void await() {
        long start = System.nanoTime();
        long pauseNanos = started ? Math.min(PAUSE_NANOS, patience.toNanos() - waitedNanos) : 0;
        try {
            long leftNanos = pauseNanos;
            while (ready.isEmpty() && !over && !closed && !declines && leftNanos > 0) {
                TimeUnit.NANOSECONDS.timedWait(this, leftNanos);
                leftNanos = pauseNanos - (System.nanoTime() - start);
            }
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
        waitedNanos += System.nanoTime() - start;
    }

    /** Whether no engine will become ready while frames are like the latest. */
    synchronized boolean isOver() {
        return (over || declines) && ready.isEmpty();
    }

    /** The engine, once it is warm; the caller then owns it. */
    synchronized Optional<Engine> take() {
        Optional<Engine> taken = ready;
        ready = Optional.empty();
        if (taken.isPresent()) {
            // Releases the sky, which is large.
            newest = Optional.empty();
        }
        return taken;
    }

    /** Stops the warm-up; closes an engine that was not taken. */
    @Override
    public synchronized void close() {
        closed = true;
        notifyAll();
        take().ifPresent(Engine::close);
    }

    private void warm() {
        try {
            opener.apply(() -> closed).ifPresent(this::warm);
        } catch (EngineException | OutOfMemoryError _) {
            // The current engine continues; opening this one by its name reports the failure.
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
            while (!warm && awaitUse(engine, trial) && (again || !trial.isHopeless())) {
                FrameInput now = newest.orElseThrow();
                if (!Work.of(now).equals(trial.work)) {
                    trial = new Trial(engine, now);
                } else if (trial.isHopeless()) {
                    // The current view may differ in cost: one more trial with it.
                    again = false;
                    trial = new Trial(engine, now);
                }
                trial.look(now);
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

    /**
     * Waits while a trial could not show that the engine is faster: it leaves the frame to the kernel, or it is warm
     * and the current engine has not finished a frame to beat.
     *
     * @return false once closed
     */
    private synchronized boolean awaitUse(Engine engine, Trial trial) {
        try {
            declines = engine.declines(newest.orElseThrow());
            while (!closed && (declines || (framesToBeat == 0 && trial.frames.areSettled()))) {
                notifyAll();
                wait();
                boolean declined = declines;
                declines = engine.declines(newest.orElseThrow());
                if (declined && !declines) {
                    // Frames rendered meanwhile may have been parts of pictures.
                    framesToBeat = 0;
                }
            }
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
        return !closed;
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

    /** What determines the time per pixel sample besides the view; times of different work are not comparable. */
    private record Work(int room, int shadowSamples, int bounces) {
        static Work of(FrameInput input) {
            return new Work(input.bodies().room(), input.shadowSamples(), input.bounces());
        }
    }

    /** The rows of a picture that is rendered in bands: of the sky alone they take less than others. */
    private record Rows(int first, int count, int height) {
        static Rows of(FrameInput input) {
            return new Rows(input.firstRow(), input.rows(), input.height());
        }
    }

    /** Small frames of one input. */
    private static final class Trial {
        private final Engine engine;
        private final Work work;
        private Rows rows;
        private SettlingFrames frames;
        private double samples;
        private long spentNanos;

        Trial(Engine engine, FrameInput input) {
            this.engine = engine;
            work = Work.of(input);
            turnTo(input);
        }

        /** Renders the rows of the current engine's latest frame from now on. */
        void look(FrameInput input) {
            if (!Rows.of(input).equals(rows)) {
                turnTo(input);
            }
        }

        private void turnTo(FrameInput input) {
            // One sample per pixel: the time per sample is the same, and a trial of many would take as long as the
            // frame.
            FrameInput whole = SettlingFrames.small(input).withSamples(0, 1);
            int first = (int) ((long) input.firstRow() * whole.height() / input.height());
            int count = (int) Math.ceilDiv((long) input.rows() * whole.height(), input.height());
            FrameInput small = whole.band(first, Math.min(count, whole.height() - first));
            rows = Rows.of(input);
            frames = new SettlingFrames(engine, small);
            samples = (double) small.width() * small.rows() * small.samplesPerPixel();
        }

        /** Renders a frame; returns its nanoseconds per pixel sample. */
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
