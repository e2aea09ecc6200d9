package dev.twister.render;

import dev.twister.engine.Engine;
import dev.twister.engine.FrameFit;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;
import dev.twister.world.TonedPixels;
import java.util.function.DoubleFunction;
import java.util.function.IntConsumer;

/**
 * Renders pictures with motion blur by another engine: the mean of moments of the time in which the shutter is open,
 * each with samples of its own. A sample's moment depends on its number alone, so that parts of a picture fit.
 */
final class ShutterEngine implements Engine {
    /** Each doubling of the number of samples brings as many moments; twice as many samples share one. */
    private static final int MOMENTS_PER_DOUBLING = 32;

    private static final double GOLDEN_RATIO = (Math.sqrt(5) - 1) / 2;

    private final Engine engine;
    private final DoubleFunction<FrameInput> moments;
    private final IntConsumer drawn;
    private Frame pass = Frame.ofRadiance(1, 1);

    /**
     * An engine for one picture.
     *
     * @param engine is not closed with this one
     * @param moments the whole picture at a part of the shutter's time, in [0, 1)
     * @param drawn receives the number of samples so far
     */
    ShutterEngine(Engine engine, DoubleFunction<FrameInput> moments, IntConsumer drawn) {
        this.engine = engine;
        this.moments = moments;
        this.drawn = drawn;
    }

    /**
     * A moment.
     *
     * @param part of the shutter's time, in [0, 1)
     * @param end number of the sample after its last one
     */
    record Moment(double part, int end) {
        /** The moment of a sample; any run of moments is spread evenly, by multiples of the golden ratio. */
        static Moment of(int sample) {
            int doublings = Math.max(0, log2(sample) - log2(MOMENTS_PER_DOUBLING));
            int place = sample >> doublings;
            double turns = 0.5 + (place + MOMENTS_PER_DOUBLING * doublings) * GOLDEN_RATIO;
            return new Moment(turns - Math.floor(turns), (place + 1) << doublings);
        }

        private static int log2(int number) {
            return Integer.SIZE - 1 - Integer.numberOfLeadingZeros(number);
        }
    }

    @Override
    public String id() {
        return engine.id();
    }

    @Override
    public String device() {
        return engine.device();
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        FrameFit.check(input, frame);
        if (pass.width() != frame.width() || pass.height() != frame.height() || pass.layerCount() != input.layers()) {
            pass = Frame.ofRadiance(frame.width(), frame.height(), input.layers());
        }
        pass.stopWhen(frame::isToStop);
        Frame mean = frame.isLinear() ? frame : Frame.ofRadiance(frame.width(), frame.height());
        FrameTimes times = FrameTimes.NONE;
        int first = input.firstSample();
        int end = first + input.samplesPerPixel();
        int sample = first;
        while (sample < end) {
            Moment moment = Moment.of(sample);
            int samples = Math.min(moment.end(), end) - sample;
            engine.render(limited(moments.apply(moment.part()), input, sample, samples), pass);
            float weight = (float) samples / input.samplesPerPixel();
            add(pass.radiance(), weight, mean.radiance(), sample == first);
            add(pass.layers(), weight, mean.layers(), sample == first);
            times = times.plus(pass.times());
            sample += samples;
            drawn.accept(sample - first);
        }
        if (!frame.isLinear()) {
            TonedPixels.write(mean.radiance(), input, frame.argb());
        }
        frame.setTimes(times);
    }

    /** Some samples of a whole picture, of the rows and tiles of another. */
    private static FrameInput limited(FrameInput whole, FrameInput part, int sample, int samples) {
        FrameInput limited = whole.band(part.firstRow(), part.rows()).withSamples(sample, samples);
        boolean[] wanted = new boolean[part.tilesAcross() * Math.ceilDiv(part.rows(), Layout.TILE_SIDE)];
        boolean all = true;
        for (int tile = 0; tile < wanted.length; tile++) {
            wanted[tile] = part.isWanted(tile);
            all &= wanted[tile];
        }
        return all ? limited : limited.withTiles(wanted);
    }

    private static void add(float[] values, float weight, float[] sums, boolean first) {
        for (int i = 0; i < values.length; i++) {
            sums[i] = weight * values[i] + (first ? 0 : sums[i]);
        }
    }

    /** Leaves the other engine open. */
    @Override
    public void close() {}
}
