package dev.twister.engine.tornado;

import dev.twister.engine.EngineException;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import uk.ac.manchester.tornado.api.DataRange;
import uk.ac.manchester.tornado.api.TornadoExecutionResult;
import uk.ac.manchester.tornado.api.types.arrays.FloatArray;
import uk.ac.manchester.tornado.api.types.arrays.IntArray;

/**
 * What the kernel writes: pixels or radiance, and layers. The first two are outside the heap and have room for larger
 * pictures; only the frame's part of them is read back. Pixels stay there, radiance is copied into the frame.
 */
final class DeviceOutput {
    private static final int CHANNELS = 3;

    private final boolean linear;
    private final PixelSlots slots;
    private final FloatArray radiance;
    private final float[] layers;

    DeviceOutput(FrameInput input, boolean linear) {
        this.linear = linear;
        int room = Room.ofPixels(count(input));
        slots = new PixelSlots(linear ? 1 : room);
        radiance = new FloatArray(linear ? Math.multiplyExact(CHANNELS, room) : 1);
        radiance.init(Float.NaN);
        layers = new float[Math.max(1, layersLength(input))];
    }

    IntArray pixels() {
        return slots.pixels();
    }

    FloatArray radiance() {
        return radiance;
    }

    float[] layers() {
        return layers;
    }

    /** What is read back with {@link #read} alone. */
    Object picture() {
        return linear ? radiance : slots.pixels();
    }

    /** Whether the frame of this input is of the same kind and has room. */
    boolean fits(FrameInput input, Frame frame) {
        return frame.isLinear() == linear
                && count(input) <= (linear ? radiance.getSize() / CHANNELS : slots.room())
                && Math.max(1, layersLength(input)) == layers.length;
    }

    /** Number of the pixel where those of the frame begin. */
    int firstPixel(Frame frame) {
        return linear ? 0 : slots.firstPixel(frame);
    }

    /**
     * Reads the frame's part of the device's buffer, and returns how long that took, in nanoseconds.
     *
     * @param result of the kernel's run, which has read the layers
     * @param firstPixel of the frame
     */
    long read(TornadoExecutionResult result, FrameInput input, Frame frame, int firstPixel) {
        int count = count(input);
        long start = System.nanoTime();
        if (linear) {
            result.transferToHost(new DataRange(radiance).withSize((long) CHANNELS * count));
        } else {
            result.transferToHost(
                    new DataRange(slots.pixels()).withOffset(firstPixel).withSize(count));
        }
        long nanos = System.nanoTime() - start;
        if (linear) {
            MemorySegment.copy(radiance.getSegment(), ValueLayout.JAVA_FLOAT, 0, frame.radiance(), 0, CHANNELS * count);
            System.arraycopy(layers, 0, frame.layers(), 0, frame.layers().length);
        } else {
            slots.hand(frame, firstPixel);
        }
        return nanos;
    }

    /**
     * Drivers can fail without an exception. The buffers of a new plan start with values that no kernel writes.
     *
     * @throws EngineException if they are still there
     */
    void requireDrawn(FrameInput input, int firstPixel) {
        int count = count(input);
        if (linear) {
            if (Float.isNaN(radiance.get(0)) && Float.isNaN(radiance.get(CHANNELS * count - 1))) {
                throw new EngineException("the device left the picture undrawn");
            }
            return;
        }
        for (int i = 0; i < count; i++) {
            if (slots.pixels().get(firstPixel + i) == PixelSlots.NOT_DRAWN) {
                throw new EngineException("the device left pixels undrawn; its driver may have refused the grid of "
                        + input.width() + " x " + input.rows());
            }
        }
    }

    /** Bytes that {@link #read} reads, and those of layers. */
    static long bytes(FrameInput input, boolean linear) {
        return (linear ? (long) CHANNELS * Float.BYTES : Integer.BYTES) * count(input)
                + (long) Float.BYTES * layersLength(input);
    }

    private static int count(FrameInput input) {
        return Math.multiplyExact(input.width(), input.rows());
    }

    private static int layersLength(FrameInput input) {
        return Math.multiplyExact(CHANNELS * input.layers(), count(input));
    }
}
