package dev.twister.physics;

import dev.twister.threads.Crew;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;

/** Runs many small tasks on all threads. The assignment to threads varies, so tasks must be independent. */
final class Team implements AutoCloseable {
    /** Work on the bodies from {@code from} to before {@code to}. */
    interface Range {
        void work(int from, int to);
    }

    private final int threads;
    private final Crew crew;
    private final AtomicInteger next = new AtomicInteger();
    private volatile IntConsumer task = Team::rest;
    private volatile int tasks;

    Team(int threads) {
        this.threads = threads;
        crew = new Crew("physics", threads, _ -> takeTasks());
    }

    /** Runs the task with 0 to count - 1; returns when all are done. */
    void each(int count, IntConsumer newTask) {
        if (threads == 1 || count < 2) {
            for (int index = 0; index < count; index++) {
                newTask.accept(index);
            }
            return;
        }
        task = newTask;
        tasks = count;
        next.set(0);
        crew.work();
        task = Team::rest;
    }

    /** Splits the range from {@code from} to before {@code to} into chunks of the given size. */
    void inChunks(int from, int to, int size, Range work) {
        each(Math.ceilDiv(to - from, size), chunk -> {
            int start = from + chunk * size;
            work.work(start, Math.min(to, start + size));
        });
    }

    private static void rest(@SuppressWarnings("unused") int index) {}

    private void takeTasks() {
        int count = tasks;
        IntConsumer own = task;
        for (int index = next.getAndIncrement(); index < count; index = next.getAndIncrement()) {
            own.accept(index);
        }
    }

    @Override
    public void close() {
        crew.close();
    }
}
