package dev.twister.engine;

import com.google.auto.service.AutoService;
import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;

/** The engines that need only the JVM: the paper's two baselines. */
@AutoService(EngineProvider.class)
public final class JvmEngines implements EngineProvider {
    public static final String SEQUENTIAL = "sequential";
    public static final String PARALLEL = "parallel";

    /** The engine that is ready at once on every machine and uses all cores. */
    public static EngineOffer parallel() {
        int threads = Runtime.getRuntime().availableProcessors();
        return offer(
                PARALLEL,
                threads == 1 ? "one thread of this JVM" : threads + " threads of this JVM",
                "plain Java, the rows spread over all threads",
                JvmEngines::drawInParallel);
    }

    @Override
    public List<EngineOffer> offers() {
        return List.of(
                offer(SEQUENTIAL, "one thread of this JVM", "plain Java, one thread", JvmEngines::drawInTurn),
                parallel());
    }

    private static EngineOffer offer(String id, String device, String description, Rows rows) {
        return EngineOffer.working(id, device, description, () -> new JvmEngine(id, device, rows));
    }

    private static long drawInTurn(FrameInput input, FrameStop stop) {
        return drawRows(input, stop, new AtomicInteger());
    }

    /**
     * Each element of the stream takes one row after the other: the caller then waits for the last rows alone, and its
     * interrupt, which a parallel stream hides while its caller waits, is seen.
     */
    private static long drawInParallel(FrameInput input, FrameStop stop) {
        AtomicInteger next = new AtomicInteger();
        return IntStream.range(0, ForkJoinPool.getCommonPoolParallelism() + 1)
                .parallel()
                .mapToLong(_ -> drawRows(input, stop, next))
                .sum();
    }

    private static long drawRows(FrameInput input, FrameStop stop, AtomicInteger next) {
        long start = ProcessorTime.ofThisThread();
        JvmKernel kernel = new JvmKernel();
        int count = stop.frame().height();
        for (int row = next.getAndIncrement(); row < count; row = next.getAndIncrement()) {
            kernel.drawRow(input, stop, row, 0, input.width());
        }
        return ProcessorTime.ofThisThread() - start;
    }

    /** Renders the rows of a frame in some order; returns nanoseconds of processor time. */
    @FunctionalInterface
    private interface Rows {
        long draw(FrameInput input, FrameStop stop);
    }

    /**
     * An engine that calls the kernel from plain Java.
     *
     * @param rows renders all rows of a frame
     */
    private record JvmEngine(String id, String device, Rows rows) implements Engine {
        @Override
        public void render(FrameInput input, Frame frame) {
            FrameFit.check(input, frame);
            long start = System.nanoTime();
            FrameStop stop = FrameStop.of(frame);
            long processorNanos = rows.draw(input, stop);
            stop.check();
            frame.setTimes(FrameTimes.onJvm(System.nanoTime() - start, processorNanos));
        }

        @Override
        public boolean drawsBandsInProportion() {
            return true;
        }

        @Override
        public void close() {
            // The JVM's engines hold nothing between frames.
        }
    }
}
