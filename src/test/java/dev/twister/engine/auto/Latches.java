package dev.twister.engine.auto;

import java.util.concurrent.CountDownLatch;

/** Waits for latches where checked exceptions are not allowed. */
final class Latches {
    private Latches() {}

    /** Returns early if the thread is interrupted and keeps its interrupt status. */
    static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
    }
}
