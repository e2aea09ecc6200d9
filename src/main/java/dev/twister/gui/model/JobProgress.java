package dev.twister.gui.model;

import dev.twister.engine.ConvergingPicture.Convergence;
import dev.twister.render.RenderProgress;
import dev.twister.render.TimeLeft;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/** How far a job is. Told by the job's thread, asked by any. */
public final class JobProgress implements RenderProgress {
    private final int frames;
    private final LongSupplier clock;
    private final BooleanSupplier canceled;
    private volatile State state = new State(false, 0, 0, 0, 0);

    /**
     * What is known.
     *
     * @param begun whether pictures are being drawn, and not files read
     * @param frame how many frames are finished
     * @param part of the next one that is drawn, in [0, 1]
     * @param startNanos when it began
     * @param nanos when that was known
     */
    private record State(boolean begun, int frame, double part, long startNanos, long nanos) {}

    /**
     * Nothing is done yet.
     *
     * @param frames of the job, 1 or more
     * @param canceled asked at every step, and while a picture is drawn; once true, the job ends
     */
    JobProgress(int frames, LongSupplier clock, BooleanSupplier canceled) {
        this.frames = frames;
        this.clock = clock;
        this.canceled = canceled;
    }

    private void check() {
        if (canceled.getAsBoolean()) {
            throw new CancellationException();
        }
    }

    @Override
    public boolean isStopped() {
        return canceled.getAsBoolean();
    }

    @Override
    public void settling(int done, int all) {
        check();
    }

    @Override
    public void moved() {
        check();
    }

    @Override
    public void begin() {
        long now = clock.getAsLong();
        state = new State(true, 0, 0, now, now);
    }

    @Override
    public void part(String engine, double part, Optional<Convergence> pass) {
        State now = state;
        state = new State(true, now.frame(), part, now.startNanos(), clock.getAsLong());
        check();
    }

    @Override
    public void frame() {
        State now = state;
        state = new State(true, now.frame() + 1, 0, now.startNanos(), clock.getAsLong());
        check();
    }

    /** The finished part, in [0, 1]; empty if not known yet. */
    public Optional<Double> part() {
        State now = state;
        return now.begun() ? Optional.of(part(now)) : Optional.empty();
    }

    private double part(State now) {
        return (now.frame() + now.part()) / frames;
    }

    /** The time left, counted down from the last estimate; empty if there is none. */
    Optional<Duration> left() {
        State now = state;
        double part = part(now);
        return part == 0
                ? Optional.empty()
                : Optional.of(TimeLeft.of(now.nanos() - now.startNanos(), part)
                                .minusNanos(clock.getAsLong() - now.nanos()))
                        .map(left -> left.isNegative() ? Duration.ZERO : left);
    }

    /** The progress as displayed text:{@code Frame 12 of 240 · 34 s left}. */
    public String text() {
        State now = state;
        if (!now.begun()) {
            return "Reading the scene…";
        }
        if (now.frame() == frames) {
            return "Writing the file…";
        }
        String done =
                frames == 1 ? Math.round(100 * now.part()) + " %" : "Frame " + (now.frame() + 1) + " of " + frames;
        return done + left().map(left -> " · " + TimeLeft.text(left) + " left").orElse("");
    }
}
