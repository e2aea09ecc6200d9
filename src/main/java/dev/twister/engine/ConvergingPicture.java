package dev.twister.engine;

import dev.twister.engine.NoiseEstimate.Half;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.image.RenderStoppedException;
import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;
import dev.twister.world.TonedPixels;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * A picture that accumulates samples until its noise is low, see {@link NoiseEstimate}. Tiles whose noise is low get no
 * more samples. What a tile gets depends on its own row of tiles alone, so that it is the same in every part of a
 * picture.
 */
public final class ConvergingPicture {
    private static final int CHANNELS = 3;
    private static final int SIDE = Layout.TILE_SIDE;

    /** Samples per pixel in each half of the first pass. */
    private static final int FIRST_SAMPLES = 4;

    /** A tile with fewer samples is not done: light that few samples find may not have been found yet. */
    private static final int LEAST_SAMPLES = 16;

    /** The same where no clamp bounds what one sample finds. */
    private static final int LEAST_UNCLAMPED = 32;

    /** Limit of samples per pixel in one call of an engine, so that progress is reported. */
    private static final int MOST_AT_ONCE = 64;

    private final FrameInput input;
    private final Frame pass;
    private final float[][] sums;
    private final float[] layers;

    /** Without background: the sums over white, in which the noise of alpha shows. */
    private final float[][] overWhite;

    private final boolean[] wanted;
    private final boolean[] low;
    private final int[] samplesOfTile;
    private double[] noise;
    private int samplesOfHalf;
    private FrameTimes times = FrameTimes.NONE;

    private ConvergingPicture(FrameInput input, Frame frame) {
        this.input = input;
        pass = Frame.ofRadiance(input.width(), input.rows(), input.layers());
        pass.stopWhen(frame::isToStop);
        sums = new float[2][pass.radiance().length];
        layers = new float[pass.layers().length];
        overWhite = new float[2][input.isCut() ? pass.radiance().length : 0];
        wanted = new boolean[input.tilesAcross() * Math.ceilDiv(input.rows(), SIDE)];
        Arrays.fill(wanted, true);
        low = new boolean[wanted.length];
        samplesOfTile = new int[wanted.length];
        noise = new double[wanted.length];
    }

    /**
     * How far a picture has converged.
     *
     * @param samples per pixel so far in tiles that are not done; in the end the largest number of any tile
     * @param noise estimated standard error of the noisiest tile, relative to white
     * @param part of the work that is done, in [0, 1], if noise falls with the square root of the samples
     */
    public record Convergence(int samples, double noise, double part) {}

    /**
     * A picture that has converged.
     *
     * @param samplesOfTile samples of each pixel in each square of {@link Layout#TILE_SIDE} pixels, from the top left
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    public record Converged(Convergence reached, int[] samplesOfTile) {}

    /**
     * Renders a picture, or a band of rows, with as many samples as necessary, from the input's first sample on.
     *
     * @param frame receives the picture, linear or not, and the total times of all passes
     * @param bound the noise to reach, relative to white; with 0 the picture gets all samples
     * @param mostSamples limit of samples per pixel, at least 8, even if more noise is left
     * @param watcher called after each pass
     * @throws RenderStoppedException as {@link Engine#render}; the frame then holds the samples so far
     */
    public static Converged draw(
            Engine engine,
            FrameInput input,
            Frame frame,
            double bound,
            int mostSamples,
            Consumer<Convergence> watcher) {
        FrameFit.check(input, frame);
        ConvergingPicture picture = new ConvergingPicture(input, frame);
        try {
            Convergence reached = picture.converge(engine, bound, mostSamples, watcher);
            picture.write(frame);
            return new Converged(reached, picture.samplesOfTile);
        } catch (RenderStoppedException stopped) {
            picture.write(frame);
            throw stopped;
        }
    }

    private Convergence converge(Engine engine, double bound, int mostSamples, Consumer<Convergence> watcher) {
        int most = mostSamples / 2;
        int more = Math.min(FIRST_SAMPLES, most);
        Convergence reached = new Convergence(0, Double.MAX_VALUE, 0);
        while (more > 0) {
            add(engine, more);
            estimate(bound);
            more = isDone() ? 0 : Math.min(more(), most - samplesOfHalf);
            reached = reached(bound, mostSamples, more == 0);
            watcher.accept(reached);
        }
        return reached;
    }

    /** Samples per pixel and half of the next pass: half as many as so far. */
    private int more() {
        return Math.min(Math.ceilDiv(samplesOfHalf, 2), MOST_AT_ONCE);
    }

    private void add(Engine engine, int samples) {
        int first = input.firstSample() + 2 * samplesOfHalf;
        for (int half = 0; half < sums.length; half++) {
            FrameInput sampled = input.withSamples(first + half * samples, samples);
            try {
                engine.render(isAnyDone() ? sampled.withTiles(wanted) : sampled, pass);
            } catch (RenderStoppedException stopped) {
                if (samplesOfHalf == 0 && half == 0) {
                    // The first pixels are all there is.
                    addPass(samples, half);
                }
                throw stopped;
            }
            times = times.plus(pass.times());
            addPass(samples, half);
        }
        samplesOfHalf += samples;
    }

    private void addPass(int samples, int half) {
        for (int tile = 0; tile < wanted.length; tile++) {
            if (wanted[tile]) {
                addTile(tile, samples, pass.radiance(), 0, sums[half]);
                if (input.isCut()) {
                    addOverWhite(tile, samples, overWhite[half]);
                }
                for (int layer = 0; layer < input.layers(); layer++) {
                    addTile(tile, samples, pass.layers(), pass.firstOf(layer), layers);
                }
                samplesOfTile[tile] += samples;
            }
        }
    }

    private void addOverWhite(int tile, int samples, float[] to) {
        float white = 1 / input.view().frame()[Layout.EXPOSURE_SCALE];
        int alpha = pass.firstOf(pass.layerCount() - 1);
        forRows(tile, (first, end) -> {
            for (int i = first; i < end; i++) {
                to[i] += samples * (pass.radiance()[i] + white * (1 - pass.layers()[alpha + i]));
            }
        });
    }

    private void addTile(int tile, int samples, float[] from, int plane, float[] to) {
        forRows(tile, (first, end) -> {
            for (int i = plane + first; i < plane + end; i++) {
                to[i] += samples * from[i];
            }
        });
    }

    /** Calls for each of a tile's rows, with its first value and the one after its last. */
    private void forRows(int tile, Span span) {
        int left = tile % input.tilesAcross() * SIDE;
        int top = tile / input.tilesAcross() * SIDE;
        int right = Math.min(left + SIDE, pass.width());
        for (int row = top; row < Math.min(top + SIDE, pass.height()); row++) {
            span.take(CHANNELS * (row * pass.width() + left), CHANNELS * (row * pass.width() + right));
        }
    }

    @FunctionalInterface
    private interface Span {
        void take(int first, int end);
    }

    private double[] noise(float[][] halves) {
        return new NoiseEstimate(pass.width(), input.view().frame())
                .tiles(
                        new Half(halves[0], tile -> samplesOfTile[tile] / 2),
                        new Half(halves[1], tile -> samplesOfTile[tile] / 2));
    }

    /** A tile is done if its noise is low after two passes: once may be by chance. */
    private void estimate(double bound) {
        double[] now = noise(sums);
        if (input.isCut()) {
            double[] white = noise(overWhite);
            Arrays.setAll(now, tile -> Math.max(now[tile], white[tile]));
        }
        for (int tile = 0; tile < wanted.length; tile++) {
            if (wanted[tile]) {
                noise[tile] = now[tile];
                boolean before = low[tile];
                low[tile] = bound > 0 && now[tile] <= bound;
                wanted[tile] = !(before && low[tile] && samplesOfTile[tile] >= leastSamples());
            }
        }
    }

    private int leastSamples() {
        boolean unclamped = input.tracesPaths() && input.view().frame()[Layout.CLAMP] == 0;
        return unclamped ? LEAST_UNCLAMPED : LEAST_SAMPLES;
    }

    private boolean isDone() {
        boolean any = false;
        for (boolean tile : wanted) {
            any |= tile;
        }
        return !any;
    }

    private boolean isAnyDone() {
        boolean any = false;
        for (boolean tile : wanted) {
            any |= !tile;
        }
        return any;
    }

    private Convergence reached(double bound, int most, boolean last) {
        double done = 0;
        double all = 0;
        for (int tile = 0; tile < wanted.length; tile++) {
            done += samplesOfTile[tile];
            all += wanted[tile] ? expected(tile, bound, most) : samplesOfTile[tile];
        }
        double worst = Arrays.stream(noise).max().orElse(0);
        return new Convergence(2 * samplesOfHalf, worst, last ? 1 : done / all);
    }

    /** Samples of a tile in the end, if noise falls with their square root; it gets one more pass at least. */
    private double expected(int tile, double bound, int most) {
        double ratio = noise[tile] / bound;
        double least = Math.min(most, 2 * (samplesOfHalf + more()));
        return bound > 0 ? Math.clamp(samplesOfTile[tile] * ratio * ratio, least, most) : most;
    }

    private void write(Frame frame) {
        float[] radiance = frame.isLinear() ? frame.radiance() : pass.radiance();
        for (int tile = 0; tile < wanted.length; tile++) {
            float average = 1f / Math.max(1, samplesOfTile[tile]);
            forRows(tile, (first, end) -> {
                for (int i = first; i < end; i++) {
                    radiance[i] = (sums[0][i] + sums[1][i]) * average;
                    for (int layer = 0; layer < input.layers(); layer++) {
                        int at = pass.firstOf(layer) + i;
                        frame.layers()[at] = layers[at] * average;
                    }
                }
            });
        }
        if (!frame.isLinear()) {
            TonedPixels.write(radiance, input, frame.argb());
        }
        frame.setTimes(times);
    }
}
