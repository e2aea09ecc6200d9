package dev.twister.gui;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Has garbage collected before the heap has grown to many times what lives in it: the JVM lets it grow up to most of
 * the computer's memory, which is there for large scenes. Used by JavaFX's thread.
 */
final class HeapMonitor {
    /** Heaps smaller than this are left to the JVM. */
    static final long SMALL_BYTES = 400L << 20;

    /** The factor of growth at which garbage is collected even while the user works and would notice the pause. */
    private static final double LATEST = 1.5;

    /** The factor of growth at which at least half of the heap is garbage. */
    private static final double GROWTH = 2;

    private static final long LOOK_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final LongSupplier usedBytes;
    private final Runnable collect;
    private volatile boolean collecting;
    private volatile long livingBytes;
    private long lookedNanos;

    HeapMonitor() {
        this(() -> Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory(), System::gc);
    }

    /**
     * One of another heap than this JVM's.
     *
     * @param usedBytes the used part of the heap, garbage included
     * @param collect returns when that is collected
     */
    HeapMonitor(LongSupplier usedBytes, Runnable collect) {
        this.usedBytes = usedBytes;
        this.collect = collect;
    }

    /**
     * Called in every pulse.
     *
     * @param resting whether nothing is drawn, so that a pause is not noticed
     * @return the task that collects, if collecting is due
     */
    Optional<Thread> pulse(long nanos, boolean resting) {
        if (collecting || nanos - lookedNanos < LOOK_NANOS) {
            return Optional.empty();
        }
        lookedNanos = nanos;
        double due = Math.max(SMALL_BYTES, GROWTH * livingBytes);
        if (usedBytes.getAsLong() <= (resting ? due : LATEST * due)) {
            return Optional.empty();
        }
        collecting = true;
        return Optional.of(Thread.ofPlatform().daemon().name("garbage").start(() -> {
            collect.run();
            livingBytes = usedBytes.getAsLong();
            collecting = false;
        }));
    }
}
