package dev.twister.threads;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;

/**
 * Threads that do one job together, again and again, without allocating: the caller is one of them, the others sleep in
 * between.
 */
public final class Crew implements AutoCloseable {
    /** Turns of waiting before a thread sleeps: some tens of microseconds. */
    private static final int PATIENCE = 2000;

    private final IntConsumer job;
    private final List<Thread> helpers = new ArrayList<>();
    private final AtomicInteger working = new AtomicInteger();
    private volatile int round;
    private volatile boolean closed;
    private volatile Thread caller;
    private volatile Throwable failure;

    /**
     * Starts all but one of the threads.
     *
     * @param name what the threads are called after
     * @param job is called by each with its number, 0 being the caller
     */
    public Crew(String name, int threads, IntConsumer job) {
        this.job = job;
        for (int number = 1; number < threads; number++) {
            int own = number;
            Thread helper = new Thread(() -> help(own), "twister-" + name + "-" + number);
            helper.setDaemon(true);
            helper.start();
            helpers.add(helper);
        }
    }

    /**
     * Does the job once on every thread; returns when all are done.
     *
     * @throws IllegalStateException where the job fails on any of them, or the crew is closed
     * @throws OutOfMemoryError where there is too little memory for it on any of them
     */
    public void work() {
        failure = null;
        caller = Thread.currentThread();
        begin();
        for (int helper = 0; helper < helpers.size(); helper++) {
            LockSupport.unpark(helpers.get(helper));
        }
        attempt(0);
        for (int turn = 0; working.get() > 0; turn++) {
            await(turn);
        }
        if (failure instanceof OutOfMemoryError memory) {
            // The caller knows what needs the memory, and how to ask for less.
            throw memory;
        }
        if (failure != null) {
            throw new IllegalStateException("the work failed: " + failure, failure);
        }
    }

    /** A helper that sees the crew closed looks for a last round; so none begins after that. */
    private synchronized void begin() {
        if (closed) {
            throw new IllegalStateException("closed");
        }
        working.set(helpers.size());
        round++;
    }

    private void help(int number) {
        int seen = 0;
        boolean ended = false;
        while (!ended) {
            for (int turn = 0; round == seen && !closed; turn++) {
                await(turn);
            }
            // Who works counts on every helper, even in the round in which the crew was closed.
            ended = round == seen;
            if (!ended) {
                seen = round;
                attempt(number);
                if (working.decrementAndGet() == 0) {
                    LockSupport.unpark(caller);
                }
            }
        }
    }

    private void attempt(int number) {
        try {
            job.accept(number);
        } catch (RuntimeException | Error e) {
            failure = e;
        }
    }

    private void await(int turn) {
        if (turn < PATIENCE) {
            Thread.onSpinWait();
        } else {
            LockSupport.park(this);
        }
    }

    @Override
    public void close() {
        synchronized (this) {
            closed = true;
        }
        helpers.forEach(LockSupport::unpark);
    }
}
