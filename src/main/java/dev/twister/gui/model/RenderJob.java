package dev.twister.gui.model;

import dev.twister.image.RenderStoppedException;
import dev.twister.render.RenderOrder;
import dev.twister.render.Renderer;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
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
}
