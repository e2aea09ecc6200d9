package dev.twister.image;

import java.nio.IntBuffer;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * The pixels an engine fills, either 8-bit ARGB or linear radiance, never both.
 *
 * <p>The arrays are not copied: they may be read after the engine's {@code render} has returned, until the next call
 * with the same frame. Pixels of a device are outside the heap until somebody asks for the array.
 */
public final class Frame {
    private static final int CHANNELS = 3;
    private static final int[] NO_PIXELS = {};
    private static final float[] NO_RADIANCE = {};

    private final int width;
    private final int height;
    private final int[] argb;
    private final IntBuffer inArray;
    private final float[] radiance;
    private final float[] layers;
    private volatile Optional<IntBuffer> outside = Optional.empty();
    private FrameTimes times = FrameTimes.NONE;
    private BooleanSupplier stop = () -> false;

    private Frame(int width, int height, int[] argb, float[] radiance, float[] layers) {
        this.width = width;
        this.height = height;
        this.argb = argb;
        inArray = IntBuffer.wrap(argb);
        this.radiance = radiance;
        this.layers = layers;
    }

    /** A frame of {@code width * height} ints, 0xAARRGGBB, row by row from the top. */
    public static Frame ofPixels(int width, int height) {
        return new Frame(width, height, new int[Math.multiplyExact(width, height)], NO_RADIANCE, NO_RADIANCE);
    }

    /** A frame of {@code 3 * width * height} floats: linear red, green, blue of each pixel, row by row from the top. */
    public static Frame ofRadiance(int width, int height) {
        return ofRadiance(width, height, 0);
    }

    /** As above, with further layers of three floats per pixel each, one after the other. */
    public static Frame ofRadiance(int width, int height, int layers) {
        int plane = Math.multiplyExact(CHANNELS, Math.multiplyExact(width, height));
        return new Frame(width, height, NO_PIXELS, new float[plane], new float[Math.multiplyExact(layers, plane)]);
    }

    /** A frame of the same kind and width, stopped by the same condition. */
    public Frame ofRows(int rows) {
        Frame part = isLinear() ? ofRadiance(width, rows, layerCount()) : ofPixels(width, rows);
        part.stop = stop;
        return part;
    }

    /**
     * Sets when an engine stops to render into this frame before it is complete.
     *
     * @param condition asked often and by several threads; once true, it must stay true
     */
    public void stopWhen(BooleanSupplier condition) {
        stop = condition;
    }

    /** Whether an engine that renders into this frame must stop. */
    public boolean isToStop() {
        return stop.getAsBoolean();
    }

    /** Copies the rows of a frame of the same kind and width to those from {@code firstRow} on. */
    public void put(Frame band, int firstRow) {
        int first = width * firstRow;
        if (isLinear()) {
            System.arraycopy(band.radiance, 0, radiance, CHANNELS * first, band.radiance.length);
            for (int layer = 0; layer < layerCount(); layer++) {
                System.arraycopy(
                        band.layers,
                        band.firstOf(layer),
                        layers,
                        firstOf(layer) + CHANNELS * first,
                        band.radiance.length);
            }
        } else {
            System.arraycopy(band.argb(), 0, argb(), first, band.argb.length);
        }
    }

    /** A copy of some rows, with this frame's times. */
    public Frame rows(int firstRow, int rows) {
        Frame copy = ofRows(rows);
        int first = width * firstRow;
        if (isLinear()) {
            System.arraycopy(radiance, CHANNELS * first, copy.radiance, 0, copy.radiance.length);
            for (int layer = 0; layer < layerCount(); layer++) {
                System.arraycopy(
                        layers,
                        firstOf(layer) + CHANNELS * first,
                        copy.layers,
                        copy.firstOf(layer),
                        copy.radiance.length);
            }
        } else {
            System.arraycopy(argb(), first, copy.argb, 0, copy.argb.length);
        }
        copy.times = times;
        return copy;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** Whether this frame holds linear radiance instead of 8-bit pixels. */
    public boolean isLinear() {
        return argb.length == 0;
    }

    /** The pixels as 0xAARRGGBB; empty in a linear frame. Pixels that are outside the heap are moved into the array. */
    public int[] argb() {
        if (outside.isPresent()) {
            moveIntoArray();
        }
        return argb;
    }

    private synchronized void moveIntoArray() {
        outside.ifPresent(pixels -> pixels.get(0, argb));
        outside = Optional.empty();
    }

    /** The pixels where they are, without a copy: the same buffer as long as they stay there. */
    public IntBuffer pixels() {
        return outside.orElse(inArray);
    }

    /**
     * Sets the pixels without copying them, in a frame that is not linear.
     *
     * @param buffer outside the heap; keeps its content until the next render into this frame, or for as long as
     *     somebody has the frame
     */
    public void setPixels(IntBuffer buffer) {
        outside = Optional.of(buffer);
    }

    /** The linear radiance, three floats per pixel; empty in a frame of pixels. */
    public float[] radiance() {
        return radiance;
    }

    /** The layers beside the radiance, one after the other: three floats per pixel each. */
    public float[] layers() {
        return layers;
    }

    /** Number of layers beside the radiance. */
    public int layerCount() {
        return isLinear() ? layers.length / radiance.length : 0;
    }

    /** Index of a layer's first value in {@link #layers}. */
    public int firstOf(int layer) {
        return layer * radiance.length;
    }

    /** How long the last render into this frame took, step by step. */
    public FrameTimes times() {
        return times;
    }

    public void setTimes(FrameTimes newTimes) {
        times = newTimes;
    }
}
