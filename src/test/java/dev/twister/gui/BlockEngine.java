package dev.twister.gui;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.JvmEngines;
import dev.twister.engine.JvmKernel;
import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;

/**
 * Draws one pixel of each block of {@link #SIDE} x {@link #SIDE} as {@code parallel} does and gives the block its
 * color. For tests that need a picture at once and do not read single pixels.
 */
final class BlockEngine implements Engine {
    private static final int SIDE = 16;

    private static final int CHANNELS = 3;

    /** Half of what is between two pulses. */
    private static final long PAUSE_NANOS = 8_000_000;

    private final EngineOffer stood = JvmEngines.parallel();
    private final ThreadLocal<JvmKernel> kernels = ThreadLocal.withInitial(JvmKernel::new);

    /** It stands for {@code parallel} by its name. */
    static EngineOffer offer() {
        EngineOffer stood = JvmEngines.parallel();
        return EngineOffer.working(stood.id(), stood.device(), stood.description(), BlockEngine::new);
    }

    @Override
    public String id() {
        return stood.id();
    }

    @Override
    public String device() {
        return stood.device();
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        long start = System.nanoTime();
        IntStream.range(0, Math.ceilDiv(frame.height(), SIDE))
                .parallel()
                .forEach(block -> drawBlocks(input, frame, SIDE * block));
        frame.setTimes(FrameTimes.onJvm(System.nanoTime() - start));
        if (!frame.isLinear()) {
            // A picture that is not refined is drawn again and again, beside the test.
            LockSupport.parkNanos(PAUSE_NANOS);
        }
    }

    private void drawBlocks(FrameInput input, Frame frame, int firstRow) {
        JvmKernel kernel = kernels.get();
        FrameStop whole = FrameStop.of(frame);
        int width = frame.width();
        int layers = frame.layerCount();
        int endRow = Math.min(firstRow + SIDE, frame.height());
        for (int column = 0; column < width; column += SIDE) {
            kernel.drawRow(input, whole, firstRow, column, column + 1);
            int drawn = width * firstRow + column;
            int columns = Math.min(SIDE, width - column);
            for (int row = firstRow; row < endRow; row++) {
                int first = width * row + column;
                if (frame.isLinear()) {
                    fill(frame.radiance(), 0, drawn, first, columns);
                } else {
                    Arrays.fill(frame.argb(), first, first + columns, frame.argb()[drawn]);
                }
                for (int layer = 0; layer < layers; layer++) {
                    fill(frame.layers(), frame.firstOf(layer), drawn, first, columns);
                }
            }
        }
    }

    private static void fill(float[] values, int layer, int drawn, int first, int columns) {
        for (int pixel = first; pixel < first + columns; pixel++) {
            System.arraycopy(values, layer + CHANNELS * drawn, values, layer + CHANNELS * pixel, CHANNELS);
        }
    }

    @Override
    public boolean drawsBandsInProportion() {
        return true;
    }

    @Override
    public void close() {
        // It holds nothing between frames.
    }
}
