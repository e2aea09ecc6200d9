package dev.twister.gui;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;

/**
 * Calls an action in every pulse of JavaFX while something happens, and a few times a second otherwise: an animation
 * that never ends costs 7 % of a core. Used by JavaFX's thread.
 */
final class Pulses implements AutoCloseable {
    private static final long AWAKE_NANOS = TimeUnit.SECONDS.toNanos(1);
    private static final long ASLEEP_MILLIS = 100;

    private final BooleanSupplier busy;
    private final AnimationTimer timer;
    private final ScheduledExecutorService alarm = Executors.newSingleThreadScheduledExecutor(
            Thread.ofPlatform().daemon().name("pulses").factory());
    private long awakeUntilNanos;
    private volatile boolean asleep;
    private volatile boolean closed;

    /** @param busy whether something happens without a hand on the window */
    Pulses(Runnable action, BooleanSupplier busy) {
        this.busy = busy;
        timer = new AnimationTimer() {
            @Override
            public void handle(long now) {
                action.run();
                sleepUnlessBusy();
            }
        };
        ScheduledFuture<?> _ = alarm.scheduleWithFixedDelay(
                () -> {
                    if (asleep) {
                        Platform.runLater(() -> pulseAsleep(action));
                    }
                },
                ASLEEP_MILLIS,
                ASLEEP_MILLIS,
                TimeUnit.MILLISECONDS);
    }

    /** Something happens: pulses come for a while. */
    void wake() {
        awakeUntilNanos = System.nanoTime() + AWAKE_NANOS;
        if (!closed) {
            asleep = false;
            timer.start();
        }
    }

    private void sleepUnlessBusy() {
        if (busy.getAsBoolean()) {
            awakeUntilNanos = System.nanoTime() + AWAKE_NANOS;
        } else if (System.nanoTime() > awakeUntilNanos) {
            timer.stop();
            asleep = true;
        }
    }

    private void pulseAsleep(Runnable action) {
        if (asleep && !closed) {
            action.run();
            if (busy.getAsBoolean()) {
                wake();
            }
        }
    }

    @Override
    public void close() {
        closed = true;
        timer.stop();
        alarm.shutdownNow();
    }
}
