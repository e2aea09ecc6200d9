package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.MainWindow.HeapMonitor;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class HeapMonitorTest {
    private static final long SECOND = 1_000_000_000;

    private final AtomicInteger collections = new AtomicInteger();
    private long now;

    /** Collects where it is due, and returns when that is done. */
    private int collections(HeapMonitor keeper, boolean resting) throws InterruptedException {
        now += 2 * SECOND;
        Optional<Thread> collector = keeper.pulse(now, resting);
        if (collector.isPresent()) {
            collector.get().join();
        }
        return collections.get();
    }

    /** Of a heap of which so much is used before and after each collection. */
    private HeapMonitor keeper(long before, long after) {
        AtomicLong used = new AtomicLong(before);
        return new HeapMonitor(used::get, () -> {
            used.set(after);
            collections.incrementAndGet();
        });
    }

    @Test
    void aSmallHeapIsLeftAlone() throws InterruptedException {
        assertThat(collections(keeper(HeapMonitor.SMALL_BYTES, 0), true)).isZero();
    }

    @Test
    void aLargeHeapIsCollectedOnceThePictureRests() throws InterruptedException {
        HeapMonitor keeper = keeper(HeapMonitor.SMALL_BYTES + 1, 0);
        assertThat(collections(keeper, false)).isZero();
        assertThat(collections(keeper, true)).isOne();
        assertThat(collections(keeper, true)).isOne();
    }

    @Test
    void aHeapThatGoesOnGrowingIsCollectedBeforeThat() throws InterruptedException {
        assertThat(collections(keeper(2 * HeapMonitor.SMALL_BYTES, 0), false)).isOne();
    }

    @Test
    void whatLivesIsNotLookedThroughAgainAndAgain() throws InterruptedException {
        HeapMonitor keeper = keeper(4 * HeapMonitor.SMALL_BYTES, 3 * HeapMonitor.SMALL_BYTES);
        assertThat(collections(keeper, true)).isOne();
        assertThat(collections(keeper, true)).isOne();
    }
}
