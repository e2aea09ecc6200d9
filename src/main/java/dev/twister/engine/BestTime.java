package dev.twister.engine;

import java.time.Duration;
import java.util.Optional;

/** The fastest frame of a series and whether frame times have settled. Thread-safe. */
public final class BestTime {
    /**
     * Factor by which a frame must be faster to count as better: beyond the clock's noise, within one step of the JIT
     * compiler.
     */
    private static final double BETTER = 0.95;

    /** Minimum duration of the settled frames; about the longest single compilation. */
    private static final long SETTLED_NANOS = 700_000_000L;

    private static final int SETTLED_FRAMES = 20;

    private Optional<Long> bestNanos = Optional.empty();
    private long settlingNanos;
    private int settlingFrames;

    /**
     * Adds a frame.
     *
     * @param nanos the frame's time in nanoseconds
     * @param compiled whether the JIT compiler finished code meanwhile, so that the next frames may be faster
     */
    public synchronized void add(long nanos, boolean compiled) {
        if (!compiled && bestNanos.isPresent() && nanos >= BETTER * bestNanos.get()) {
            settlingNanos += nanos;
            settlingFrames++;
        } else {
            settlingNanos = 0;
            settlingFrames = 0;
        }
        bestNanos = Optional.of(Math.min(nanos, bestNanos.orElse(nanos)));
    }

    /** Whether the latest frames, at least 20 and over 0.7 s, were no faster than an earlier one. */
    public synchronized boolean isSettled() {
        return settlingFrames >= SETTLED_FRAMES && settlingNanos >= SETTLED_NANOS;
    }

    /** Discards all frames. */
    public synchronized void forget() {
        bestNanos = Optional.empty();
        settlingNanos = 0;
        settlingFrames = 0;
    }

    public synchronized Optional<Duration> found() {
        return bestNanos.map(Duration::ofNanos);
    }
}
