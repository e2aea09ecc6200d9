package dev.twister.render;

import dev.twister.engine.ConvergingPicture.Convergence;
import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.Optional;

/** Renders a picture in bands of rows, so that progress can be reported. */
public final class BandedDrawing {
    /** View rays per band; a picture of 1280 x 720 with one sample per pixel is a single band. */
    private static final long RAYS_PER_BAND = 1 << 20;

    /** With a noise bound: bands get different numbers of samples, and the first pass still keeps a device busy. */
    private static final long RAYS_PER_CONVERGING_BAND = 1 << 17;

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
     * @param fewestSamples smallest number of samples per pixel of any band
     * @param mostSamples largest number of samples per pixel of any band
     * @param noise estimated error of the noisiest part, as a share of white; 0 if it was not estimated
     */
    public record Drawn(Frame frame, int fewestSamples, int mostSamples, double noise) {
        /** The same with another frame. */
        Drawn with(Frame other) {
            return new Drawn(other, fewestSamples, mostSamples, noise);
        }
    }

    /** Renders the rows of the input; each has the same bits as in the whole picture. */
    public static Drawn draw(
            Engine engine, FrameInput input, Sampling sampling, boolean linear, RenderProgress progress) {
        int first = input.firstRow() / SQUARE * SQUARE;
        int end = Math.min(input.height(), Math.ceilDiv(input.firstRow() + input.rows(), SQUARE) * SQUARE);
        if (end - first == input.rows()) {
            return drawSquares(engine, input, sampling, linear, progress);
        }
        Drawn squares = drawSquares(engine, input.band(first, end - first), sampling, linear, progress);
        Frame rows = squares.frame().rows(input.firstRow() - first, input.rows());
        return new Drawn(rows, squares.fewestSamples(), squares.mostSamples(), squares.noise());
    }

    private static Drawn drawSquares(
            Engine engine, FrameInput input, Sampling sampling, boolean linear, RenderProgress progress) {
        int height = input.rows();
        Frame whole = linear
                ? Frame.ofRadiance(input.width(), height, input.layers())
                : Frame.ofPixels(input.width(), height);
        int rowsPerBand = rowsPerBand(input, sampling);
        int fewest = sampling.samples();
        int most = 0;
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
            Convergence reached = sampling.draw(
                    engine,
                    input.band(input.firstRow() + first, rows),
                    band,
                    pass -> progress.part(engine.id(), (before + sampling.part(pass)) / bands, Optional.of(pass)));
            fewest = Math.min(fewest, reached.samples());
            most = Math.max(most, reached.samples());
            noise = Math.max(noise, reached.noise());
            if (bands > 1) {
                whole.put(band, first);
                progress.part(engine.id(), (drawn + 1.0) / bands, Optional.empty());
            }
            times = times.plus(band.times());
        }
        whole.setTimes(times);
        return new Drawn(whole, fewest, most, noise);
    }

    /** Memory for rendering, in bytes per pixel; the bands need less than that again. */
    public static long bytesPerPixel(boolean linear) {
        return (linear ? CHANNELS : 1) * (long) Integer.BYTES;
    }

    private static int rowsPerBand(FrameInput input, Sampling sampling) {
        boolean converges = sampling.noise().isPresent();
        long raysPerRow = (long) input.width() * (converges ? Sampling.LEAST_CONVERGING : sampling.samples());
        long rows = converges ? RAYS_PER_CONVERGING_BAND / raysPerRow : RAYS_PER_BAND / raysPerRow;
        long squares = Math.max(converges ? SQUARE : MIN_ROWS, rows) / SQUARE * SQUARE;
        return (int) Math.min(squares, input.rows());
    }
}
