package dev.twister.engine;

import java.time.Duration;
import java.util.Optional;

/** The fastest of a series of frames, and whether it is likely to stay that; used by several threads. */
public final class BestTime {
    /**
     * What a frame must be faster by to count as better: less than a compiler's next step, more than a clock's noise.
     */
    private static final double BETTER = 0.95;

    /** One compilation may take about so long. */
    private static final long SETTLED_NANOS = 700_000_000L;

    private static final int SETTLED_FRAMES = 20;

    private Optional<Long> bestNanos = Optional.empty();
    private long settlingNanos;
    private int settlingFrames;

    /**
     * Adds a frame.
     *
     * @param compiled whether the JVM's compiler was at work meanwhile: the next frames may be faster
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

    /** Whether the last frames, many and over some time, were no better than one before them. */
    public synchronized boolean isSettled() {
        return settlingFrames >= SETTLED_FRAMES && settlingNanos >= SETTLED_NANOS;
    }

    /** As if no frame had been added. */
    public synchronized void forget() {
        bestNanos = Optional.empty();
        settlingNanos = 0;
        settlingFrames = 0;
    }

    public synchronized Optional<Duration> found() {
        return bestNanos.map(Duration::ofNanos);
    }
}
