package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Renders each frame with several engines at once. They take bands from one queue, as large as their measured speeds
 * ask for, so that all of them are busy until the frame's end. Engines with which frames are not shorter stay out.
 */
final class AllEngine implements Engine {
    /** Kinds of frames whose engines are remembered. */
    private static final int MOST_KINDS = 16;

    private final List<BandWorker> workers;
    private final ExecutorService threads;
    private final SequencedMap<Kind, BandTeam> teams = new LinkedHashMap<>();
    private volatile String device;

    /**
     * Frames that take about as long as each other.
     *
     * @param samplesScale number of leading zeros of the samples per pixel
     */
    private record Kind(int width, int rows, int samplesScale, int variant) {
        static Kind of(FrameInput input, Frame frame) {
            return new Kind(
                    input.width(),
                    input.rows(),
                    Integer.numberOfLeadingZeros(input.samplesPerPixel()),
                    input.variant(frame.isLinear()));
        }
    }

    /** Takes over opened engines, at least one. */
    AllEngine(List<Engine> engines) {
        workers = engines.stream().map(BandWorker::new).toList();
        device = new BandTeam(workers).device();
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
        BandTeam team = team(Kind.of(input, frame));
        List<BandWorker> taken = team.taken();
        if (taken.size() == 1) {
            taken.getFirst().engine().render(input, frame);
        } else {
            renderTogether(taken, input, frame);
            frame.setTimes(FrameTimes.onJvm(System.nanoTime() - start));
        }
        team.took(System.nanoTime() - start);
        device = team.device();
    }

    private BandTeam team(Kind kind) {
        BandTeam team = teams.remove(kind);
        if (team == null && teams.size() == MOST_KINDS) {
            // The one that was used the longest time ago.
            teams.pollFirstEntry();
        }
        BandTeam taken = team == null ? new BandTeam(workers) : team;
        teams.put(kind, taken);
        return taken;
    }

    private void renderTogether(List<BandWorker> taken, FrameInput input, Frame frame) {
        FrameStop stop = FrameStop.of(frame);
        BandQueue queue = new BandQueue(frame.height());
        double together = taken.stream().mapToDouble(BandWorker::rowsASecond).sum();
        boolean known = taken.stream().allMatch(worker -> worker.rowsASecond() > 0);
        CompletableFuture<?>[] parts = taken.stream()
                .map(worker -> {
                    Optional<Double> share = known ? Optional.of(worker.rowsASecond() / together) : Optional.empty();
                    return CompletableFuture.runAsync(() -> render(worker, input, stop, queue, share), threads);
                })
                .toArray(CompletableFuture[]::new);
        await(CompletableFuture.allOf(parts), stop);
        stop.check();
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
        boolean ended = false;
        try {
            while (!ended) {
                try {
                    all.get();
                    ended = true;
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
