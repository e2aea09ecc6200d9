package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Renders each frame with several engines at once. They take bands from one queue, as large as their measured speeds
 * ask for, so that all of them are busy until the frame's end.
 */
final class AllEngine implements Engine {
    private final String device;
    private final List<BandWorker> workers;
    private final ExecutorService threads;

    /**
     * Takes over opened engines.
     *
     * @param device the devices' names, for display
     */
    AllEngine(String device, List<Engine> engines) {
        this.device = device;
        workers = engines.stream().map(BandWorker::new).toList();
        threads = Executors.newFixedThreadPool(
                engines.size(), Thread.ofPlatform().daemon().name("bands-", 0).factory());
    }

    @Override
    public String id() {
        return AllEngines.ALL;
    }

    @Override
    public String device() {
        return device;
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        FrameFit.check(input, frame);
        long start = System.nanoTime();
        FrameStop stop = FrameStop.of(frame);
        BandQueue queue = new BandQueue(frame.height());
        double together = workers.stream().mapToDouble(BandWorker::rowsASecond).sum();
        boolean known = workers.stream().allMatch(worker -> worker.rowsASecond() > 0);
        CompletableFuture<?>[] parts = workers.stream()
                .map(worker -> {
                    Optional<Double> share = known ? Optional.of(worker.rowsASecond() / together) : Optional.empty();
                    return CompletableFuture.runAsync(() -> render(worker, input, stop, queue, share), threads);
                })
                .toArray(CompletableFuture[]::new);
        await(CompletableFuture.allOf(parts), stop);
        stop.check();
        frame.setTimes(FrameTimes.onJvm(System.nanoTime() - start));
    }

    private static void render(
            BandWorker worker, FrameInput input, FrameStop stop, BandQueue queue, Optional<Double> share) {
        try {
            worker.render(input, stop, queue, share);
        } catch (RuntimeException | Error problem) {
            queue.stop();
            throw problem;
        }
    }

    private static void await(CompletableFuture<Void> all, FrameStop stop) {
        boolean interrupted = false;
        try {
            while (!all.isDone()) {
                try {
                    all.get();
                } catch (InterruptedException _) {
                    interrupted = true;
                    stop.ask();
                }
            }
        } catch (ExecutionException problem) {
            switch (problem.getCause()) {
                case RuntimeException cause -> throw cause;
                case Error cause -> throw cause;
                case null, default -> throw new IllegalStateException(problem);
            }
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    @Override
    public void rest() {
        workers.forEach(worker -> worker.engine().rest());
    }

    @Override
    public void close() {
        threads.close();
        workers.forEach(worker -> worker.engine().close());
    }
}
