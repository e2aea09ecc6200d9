package dev.twister.render;

import dev.twister.engine.ConvergingPicture.Converged;
import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.Optional;

/** Renders a picture in bands of rows, so that progress can be reported. */
public final class BandedDrawing {
    /** View rays per band; a picture of 1280 x 720 with one sample per pixel is a single band. */
    private static final long RAYS_PER_BAND = 1 << 20;

    /**
     * With a noise bound: tiles that are not done still keep a device busy, and the sums of samples are not too large.
     */
    private static final long PIXELS_PER_CONVERGING_BAND = 1 << 18;

    /** Enough rows to keep every core busy. */
    private static final int MIN_ROWS = 64;

    /** Engines render squares of this side; bands start at its multiples so that results are rounded alike. */
    private static final int SQUARE = 16;

    private static final int CHANNELS = 3;

    private BandedDrawing() {}

    /**
     * A rendered picture.
     *
     * @param frame its times are the sums over all bands
     * @param samples number of each pixel; empty if all have the same
     * @param noise estimated error of the noisiest part, as a share of white; 0 if it was not estimated
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    public record Drawn(Frame frame, float[] samples, double noise) {
        /** The same with another frame. */
        Drawn with(Frame other) {
            return new Drawn(other, samples, noise);
        }
    }

    /** Renders the rows of the input; each has the same bits as in the whole picture. */
    public static Drawn draw(
            Engine engine, FrameInput input, Sampling sampling, boolean linear, RenderProgress progress) {
        return draw(new Bands(engine, sampling, rowsPerBand(input, sampling)), input, linear, progress);
    }

    /** As above, in one go, for an engine that takes long to begin a band. */
    static Drawn drawAtOnce(
            Engine engine, FrameInput input, Sampling sampling, boolean linear, RenderProgress progress) {
        return draw(new Bands(engine, sampling, Rendering.MAX_SIDE), input, linear, progress);
    }

    /**
     * How bands are rendered.
     *
     * @param rows most rows of a band, a multiple of {@link #SQUARE}
     */
    private record Bands(Engine engine, Sampling sampling, int rows) {}

    private static Drawn draw(Bands bands, FrameInput input, boolean linear, RenderProgress progress) {
        int first = input.firstRow() / SQUARE * SQUARE;
        int end = Math.min(input.height(), Math.ceilDiv(input.firstRow() + input.rows(), SQUARE) * SQUARE);
        if (end - first == input.rows()) {
            return drawSquares(bands, input, linear, progress);
        }
        Drawn squares = drawSquares(bands, input.band(first, end - first), linear, progress);
        int above = input.firstRow() - first;
        Frame rows = squares.frame().rows(above, input.rows());
        float[] samples = squares.samples().length == 0
                ? squares.samples()
                : Arrays.copyOfRange(squares.samples(), input.width() * above, input.width() * (above + input.rows()));
        return new Drawn(rows, samples, squares.noise());
    }

    private static Drawn drawSquares(Bands drawing, FrameInput input, boolean linear, RenderProgress progress) {
        Engine engine = drawing.engine();
        Sampling sampling = drawing.sampling();
        int height = input.rows();
        Frame whole = linear
                ? Frame.ofRadiance(input.width(), height, input.layers())
                : Frame.ofPixels(input.width(), height);
        whole.stopWhen(progress::isStopped);
        int rowsPerBand = Math.min(drawing.rows(), height);
        float[] samples = new float[sampling.noise().isPresent() ? input.width() * height : 0];
        double noise = 0;
        int bands = Math.ceilDiv(height, rowsPerBand);
        FrameTimes times = FrameTimes.NONE;
        Frame band = bands == 1 ? whole : whole.ofRows(rowsPerBand);
        for (int drawn = 0; drawn < bands; drawn++) {
            int before = drawn;
            int first = drawn * rowsPerBand;
            int rows = Math.min(rowsPerBand, height - first);
            if (rows != band.height()) {
                band = whole.ofRows(rows);
            }
            Converged converged = sampling.draw(
                    engine,
                    input.band(input.firstRow() + first, rows),
                    band,
                    pass -> progress.part(engine.id(), (before + pass.part()) / bands, Optional.of(pass)));
            noise = Math.max(noise, converged.reached().noise());
            if (samples.length > 0) {
                putSamples(converged.samplesOfTile(), input.width(), first, rows, samples);
            }
            if (bands > 1) {
                whole.put(band, first);
                progress.part(engine.id(), (drawn + 1.0) / bands, Optional.empty());
            }
            times = times.plus(band.times());
        }
        whole.setTimes(times);
        return new Drawn(whole, samples, noise);
    }

    /** Writes the samples of each pixel of a band. */
    private static void putSamples(int[] samplesOfTile, int width, int firstRow, int rows, float[] samples) {
        int across = Math.ceilDiv(width, SQUARE);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < width; column++) {
                samples[width * (firstRow + row) + column] = samplesOfTile[row / SQUARE * across + column / SQUARE];
            }
        }
    }

    /** Memory for rendering, in bytes per pixel; the bands need less than that again. */
    public static long bytesPerPixel(boolean linear) {
        return (linear ? CHANNELS : 1) * (long) Integer.BYTES;
    }

    private static int rowsPerBand(FrameInput input, Sampling sampling) {
        boolean converges = sampling.noise().isPresent();
        long rows = converges
                ? PIXELS_PER_CONVERGING_BAND / input.width()
                : RAYS_PER_BAND / ((long) input.width() * sampling.samples());
        return (int) Math.min(Math.max(converges ? SQUARE : MIN_ROWS, rows), Rendering.MAX_SIDE) / SQUARE * SQUARE;
    }
}
