package dev.twister.engine;

import com.google.auto.service.AutoService;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.List;
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
                "plain Java, a parallel stream over the rows",
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

    private static long drawInTurn(FrameInput input, Frame frame) {
        long start = ProcessorTime.ofThisThread();
        JvmKernel kernel = new JvmKernel();
        for (int row = 0; row < frame.height(); row++) {
            kernel.drawRow(input, frame, row, 0, input.width());
        }
        return ProcessorTime.ofThisThread() - start;
    }

    private static long drawInParallel(FrameInput input, Frame frame) {
        RowSpread rows = new RowSpread(frame.height());
        return IntStream.range(0, frame.height())
                .parallel()
                .mapToLong(index -> {
                    long start = ProcessorTime.ofThisThread();
                    new JvmKernel().drawRow(input, frame, rows.row(index), 0, input.width());
                    return ProcessorTime.ofThisThread() - start;
                })
                .sum();
    }

    /** Renders the rows of a frame in some order; returns nanoseconds of processor time. */
    @FunctionalInterface
    private interface Rows {
        long draw(FrameInput input, Frame frame);
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
            long processorNanos = rows.draw(input, frame);
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
