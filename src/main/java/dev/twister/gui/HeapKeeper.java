package dev.twister.gui;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Has garbage collected before the heap has grown to many times what lives in it: the JVM lets it grow up to most of
 * the computer's memory, which is there for large scenes. Used by JavaFX's thread.
 */
final class HeapKeeper {
    /** Below that the JVM has its way. */
    static final long SMALL_BYTES = 400L << 20;

    /** That it may become where somebody is at work all the time, who would notice the pause. */
    private static final double LATEST = 1.5;

    /** What is garbage by then, at least, is as much as what lives. */
    private static final double GROWTH = 2;

    private static final long LOOK_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final LongSupplier usedBytes;
    private final Runnable collect;
    private volatile boolean collecting;
    private volatile long livingBytes;
    private long lookedNanos;

    HeapKeeper() {
        this(() -> Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory(), System::gc);
    }

    /**
     * One of another heap than this JVM's.
     *
     * @param usedBytes what is used of it, garbage included
     * @param collect returns when that is collected
     */
    HeapKeeper(LongSupplier usedBytes, Runnable collect) {
        this.usedBytes = usedBytes;
        this.collect = collect;
    }

    /**
     * Called in every pulse.
     *
     * @param resting whether nothing is drawn, so that nobody notices a pause
     * @return what collects now, where that is due
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
