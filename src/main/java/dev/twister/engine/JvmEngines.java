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

    private static void drawInTurn(FrameInput input, Frame frame) {
        JvmKernel kernel = new JvmKernel();
        for (int row = 0; row < frame.height(); row++) {
            kernel.drawRow(input, frame, row, 0, input.width());
        }
    }

    private static void drawInParallel(FrameInput input, Frame frame) {
        RowSpread rows = new RowSpread(frame.height());
        IntStream.range(0, frame.height())
                .parallel()
                .forEach(index -> new JvmKernel().drawRow(input, frame, rows.row(index), 0, input.width()));
    }

    /** Renders the rows of a frame in some order. */
    @FunctionalInterface
    private interface Rows {
        void draw(FrameInput input, Frame frame);
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
            rows.draw(input, frame);
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

    /**
     * An order of a picture's rows that spreads every part of it over the whole picture. A parallel stream splits its
     * range into few parts, one per thread. With consecutive rows, a part of sky would finish long before one of
     * spheres and leave its thread idle.
     *
     * @param height the picture's height, at least 1
     * @param step distance between successive rows, modulo the height; coprime to it
     */
    record RowSpread(int height, int step) {
        /** Steps of this part of a circle spread any number of points evenly. */
        private static final double GOLDEN_SECTION = 0.6180339887498949;

        RowSpread(int height) {
            this(height, coprime(height, (int) (height * GOLDEN_SECTION)));
        }

        private static int coprime(int height, int from) {
            int step = Math.max(1, from);
            while (divisor(height, step) != 1) {
                step++;
            }
            return step;
        }

        private static int divisor(int a, int b) {
            return b == 0 ? a : divisor(b, a % b);
        }

        /** The row at an index of the order. */
        int row(int index) {
            return (int) ((long) index * step % height);
        }
    }
}
