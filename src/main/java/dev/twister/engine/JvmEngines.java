package dev.twister.engine;

import com.google.auto.service.AutoService;
import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.List;

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

    private static void drawInTurn(FrameInput input, FrameStop stop) {
        JvmKernel kernel = new JvmKernel();
        for (int row = 0; row < stop.frame().height(); row++) {
            kernel.drawRow(input, stop, row, 0, input.width());
        }
    }

    private static void drawInParallel(FrameInput input, FrameStop stop) {
        SharedRows.forEach(
                stop.frame().height(),
                () -> {
                    JvmKernel kernel = new JvmKernel();
                    return row -> kernel.drawRow(input, stop, row, 0, input.width());
                },
                stop);
    }

    /** Renders the rows of a frame in some order. */
    @FunctionalInterface
    private interface Rows {
        void draw(FrameInput input, FrameStop stop);
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
            rows.draw(input, stop);
            stop.check();
            frame.setTimes(FrameTimes.onJvm(System.nanoTime() - start));
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
