package dev.twister.engine.auto;

import java.util.concurrent.CountDownLatch;

/** Waiting where no exception may be thrown. */
final class Latches {
    private Latches() {}

    /** Returns early where the thread is interrupted, and leaves it so. */
    static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
    }
}
