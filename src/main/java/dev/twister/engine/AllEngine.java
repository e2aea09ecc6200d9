package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
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
        BandQueue queue = new BandQueue(frame.height());
        double together = workers.stream().mapToDouble(BandWorker::rowsASecond).sum();
        boolean known = workers.stream().allMatch(worker -> worker.rowsASecond() > 0);
        CompletableFuture<?>[] parts = workers.stream()
                .map(worker -> {
                    Optional<Double> share = known ? Optional.of(worker.rowsASecond() / together) : Optional.empty();
                    return CompletableFuture.runAsync(() -> render(worker, input, frame, queue, share), threads);
                })
                .toArray(CompletableFuture[]::new);
        await(CompletableFuture.allOf(parts));
        frame.setTimes(FrameTimes.onJvm(System.nanoTime() - start));
    }

    private static void render(
            BandWorker worker, FrameInput input, Frame frame, BandQueue queue, Optional<Double> share) {
        try {
            worker.render(input, frame, queue, share);
        } catch (RuntimeException | Error problem) {
            queue.stop();
            throw problem;
        }
    }

    private static void await(CompletableFuture<Void> all) {
        try {
            all.join();
        } catch (CompletionException problem) {
            switch (problem.getCause()) {
                case RuntimeException cause -> throw cause;
                case Error cause -> throw cause;
                case null, default -> throw problem;
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
