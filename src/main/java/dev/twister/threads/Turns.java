package dev.twister.threads;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;

/**
 * Hands numbers out to threads that work together, neighbors to the same thread: long runs of them at first, then ever
 * shorter ones, so that all threads end at about the same time whatever a number costs (guided self-scheduling, C. D.
 * Polychronopoulos and D. J. Kuck 1987). Each run costs something: the counter, and what neighbors on its borders
 * share, go from one core's cache to another's.
 */
public final class Turns {
    /** How many runs a thread's share of what is left would make: a number may cost a multiple of another. */
    private static final int PARTS_OF_A_SHARE = 4;

    private final int parts;
    private final int shortest;
    private final AtomicInteger next = new AtomicInteger();
    private volatile int count;

    /**
     * @param threads how many take turns
     * @param shortest how many numbers a run has at least, but for the last one
     */
    public Turns(int threads, int shortest) {
        parts = PARTS_OF_A_SHARE * threads;
        this.shortest = shortest;
    }

    /** Hands out the numbers from 0 to {@code count - 1}; no thread may be taking any. */
    public void start(int newCount) {
        count = newCount;
        next.set(0);
    }

    /** Gives the task one number after the other, as long as there are any that no other thread has got. */
    public void take(IntConsumer task) {
        int end = count;
        int first = next.get();
        while (first < end) {
            int length = Math.min(end - first, Math.max(shortest, (end - first) / parts));
            if (next.compareAndSet(first, first + length)) {
                for (int number = first; number < first + length; number++) {
                    task.accept(number);
                }
            }
            first = next.get();
        }
    }
}
