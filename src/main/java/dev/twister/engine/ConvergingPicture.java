package dev.twister.engine;

import dev.twister.engine.NoiseEstimate.Half;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.TonedPixels;
import java.util.function.Consumer;

/** A picture that accumulates samples until its noise is low, see {@link NoiseEstimate}. */
public final class ConvergingPicture {
    /** Samples per pixel in each half of the first pass. */
    private static final int FIRST_SAMPLES = 4;

    /** Limit of samples per pixel in one call of an engine, so that progress is reported. */
    private static final int MOST_AT_ONCE = 64;

    /** A pass adds at least this part of the samples so far. */
    private static final double LEAST_GROWTH = 0.125;

    private final FrameInput input;
    private final Frame pass;
    private final float[][] sums;
    private final float[] layers;
    private int samplesOfHalf;
    private FrameTimes times = FrameTimes.NONE;

    private ConvergingPicture(FrameInput input) {
        this.input = input;
        pass = Frame.ofRadiance(input.width(), input.rows(), input.layers());
        sums = new float[2][pass.radiance().length];
        layers = new float[pass.layers().length];
    }

    /**
     * How far a picture has converged.
     *
     * @param samples per pixel so far
     * @param noise estimated standard error of the noisiest block, relative to white
     */
    public record Convergence(int samples, double noise) {
        /**
         * The samples per pixel that the picture takes, if noise falls with their square root.
         *
         * @param bound the noise to reach; 0 for all samples
         * @param most limit of samples per pixel
         */
        public int expectedSamples(double bound, int most) {
            return bound > 0 ? (int) Math.clamp(Math.ceil(samples * square(noise / bound)), samples, most) : most;
        }
    }

    /**
     * Renders a picture, or a band of rows, with as many samples as necessary.
     *
     * @param frame receives the picture, linear or not, and the total times of all passes
     * @param noise the noise to reach, relative to white; with 0 the picture gets all samples
     * @param mostSamples limit of samples per pixel, at least 8, even if more noise is left
     * @param watcher called after each pass
     */
    public static Convergence draw(
            Engine engine,
            FrameInput input,
            Frame frame,
            double noise,
            int mostSamples,
            Consumer<Convergence> watcher) {
        FrameFit.check(input, frame);
        ConvergingPicture picture = new ConvergingPicture(input);
        int more = FIRST_SAMPLES;
        Convergence reached = new Convergence(0, Double.MAX_VALUE);
        while (more > 0 && reached.noise() > noise) {
            picture.add(engine, more);
            reached = new Convergence(2 * picture.samplesOfHalf, picture.noise());
            watcher.accept(reached);
            more = picture.more(reached.expectedSamples(noise, mostSamples) / 2, mostSamples / 2);
        }
        picture.write(frame);
        return reached;
    }

    /** Samples per pixel and half of the next pass: at most as many as so far, because the estimate is rough. */
    private int more(int expected, int most) {
        int least = (int) Math.ceil(LEAST_GROWTH * samplesOfHalf);
        int wanted = Math.clamp(expected - samplesOfHalf, least, samplesOfHalf);
        return Math.min(Math.min(wanted, MOST_AT_ONCE), most - samplesOfHalf);
    }

    private static double square(double value) {
        return value * value;
    }

    private void add(Engine engine, int samples) {
        int first = 2 * samplesOfHalf;
        for (int half = 0; half < sums.length; half++) {
            engine.render(input.withSamples(first + half * samples, samples), pass);
            times = times.plus(pass.times());
            for (int i = 0; i < pass.radiance().length; i++) {
                sums[half][i] += samples * pass.radiance()[i];
            }
            for (int i = 0; i < layers.length; i++) {
                layers[i] += samples * pass.layers()[i];
            }
        }
        samplesOfHalf += samples;
    }

    private double noise() {
        return new NoiseEstimate(pass.width(), input.view().frame())
                .of(new Half(sums[0], samplesOfHalf), new Half(sums[1], samplesOfHalf));
    }

    private void write(Frame frame) {
        float average = 1f / (2 * samplesOfHalf);
        float[] radiance = frame.isLinear() ? frame.radiance() : pass.radiance();
        for (int i = 0; i < radiance.length; i++) {
            radiance[i] = (sums[0][i] + sums[1][i]) * average;
        }
        for (int i = 0; i < layers.length; i++) {
            frame.layers()[i] = layers[i] * average;
        }
        if (!frame.isLinear()) {
            TonedPixels.write(radiance, input, frame.argb());
        }
        frame.setTimes(times);
    }
}
