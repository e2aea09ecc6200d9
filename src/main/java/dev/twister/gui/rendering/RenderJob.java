package dev.twister.gui.rendering;

import dev.twister.engine.ConvergingPicture.Convergence;
import dev.twister.image.RenderStoppedException;
import dev.twister.render.RenderOrder;
import dev.twister.render.RenderProgress;
import dev.twister.render.Renderer;
import dev.twister.render.TimeLeft;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Renders to files on a thread of its own, with an engine of its own; the file is what {@code twister render} gives.
 */
public final class RenderJob {
    private final RenderOrder order;
    private final Supplier<World> reader;
    private final JobProgress progress;
    private final CompletableFuture<Path> result = new CompletableFuture<>();
    private final Thread thread;
    private volatile boolean canceled;

    private RenderJob(RenderOrder order, Supplier<World> reader, LongSupplier clock) {
        this.order = order;
        this.reader = reader;
        progress = new JobProgress(order.output().range().count(), clock, () -> canceled);
        thread = Thread.ofPlatform().daemon().name("rendering to file").unstarted(this::run);
    }

    /**
     * Begins to render. Returns at once.
     *
     * @param reader gives the order's world, on the job's thread; what it throws is the job's failure
     * @param clock in nanoseconds
     */
    public static RenderJob start(RenderOrder order, Supplier<World> reader, LongSupplier clock) {
        RenderJob job = new RenderJob(order, reader, clock);
        job.thread.start();
        return job;
    }

    /** What is rendered. */
    public RenderOrder order() {
        return order;
    }

    /** How far it is; any thread may ask. */
    public JobProgress progress() {
        return progress;
    }

    /**
     * The file, or the first of numbered files; or the failure, which is a {@link CancellationException} if the job was
     * canceled. Completed on the job's thread.
     */
    public CompletableFuture<Path> result() {
        return result;
    }

    /**
     * Lets the job end soon. Files that are not whole are not left; numbered frames that are whole are. Returns at
     * once.
     */
    public void cancel() {
        canceled = true;
    }

    public boolean isCanceled() {
        return canceled;
    }

    /** Waits for the job's end, which is soon once it is canceled: after what is being drawn; whether it ended. */
    public boolean awaitEnd(Duration limit) throws InterruptedException {
        return thread.join(limit);
    }

    private void run() {
        try {
            result.complete(render());
        } catch (RenderStoppedException _) {
            result.completeExceptionally(new CancellationException());
        } catch (IOException | RuntimeException | Error problem) {
            result.completeExceptionally(problem);
        }
    }

    private void check() {
        if (canceled) {
            throw new CancellationException();
        }
    }

    private Path render() throws IOException {
        World world = reader.get();
        check();
        Renderer.render(order, world, progress);
        return order.output().firstFile();
    }

    /** How far a job is. Told by the job's thread, asked by any. */
    public static final class JobProgress implements RenderProgress {
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
            return done
                    + left().map(left -> " · " + TimeLeft.text(left) + " left").orElse("");
        }
    }
}
