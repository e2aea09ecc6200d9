package dev.twister.render;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;

/** Draws a picture in bands of rows, so that long work tells how far it is. */
public final class BandedDrawing {
    /** View rays in a band: a picture of 1280 x 720 with one a pixel is still drawn at once. */
    private static final long RAYS_PER_BAND = 1 << 20;

    /** Enough for every core to have some. */
    private static final int MIN_ROWS = 64;

    /** Engines draw in squares of as many pixels; those of bands that begin elsewhere would be rounded differently. */
    private static final int SQUARE = 16;

    private static final int CHANNELS = 3;

    private BandedDrawing() {}

    /**
     * A picture.
     *
     * @param frame its times are all bands' together
     * @param fewestSamples of a pixel
     * @param mostSamples of a pixel
     */
    public record Drawn(Frame frame, int fewestSamples, int mostSamples) {}

    /** Draws the rows of the picture that the input has, each with the bits that it has in the whole picture. */
    public static Drawn draw(
            Engine engine, FrameInput input, Sampling sampling, boolean linear, RenderProgress progress) {
        int first = input.firstRow() / SQUARE * SQUARE;
        int end = Math.min(input.height(), Math.ceilDiv(input.firstRow() + input.rows(), SQUARE) * SQUARE);
        if (end - first == input.rows()) {
            return drawSquares(engine, input, sampling, linear, progress);
        }
        Drawn squares = drawSquares(engine, input.band(first, end - first), sampling, linear, progress);
        Frame rows = squares.frame().rows(input.firstRow() - first, input.rows());
        return new Drawn(rows, squares.fewestSamples(), squares.mostSamples());
    }

    private static Drawn drawSquares(
            Engine engine, FrameInput input, Sampling sampling, boolean linear, RenderProgress progress) {
        int height = input.rows();
        Frame whole = linear ? Frame.ofRadiance(input.width(), height) : Frame.ofPixels(input.width(), height);
        int rowsPerBand = rowsPerBand(input, sampling.usual());
        if (rowsPerBand >= height) {
            int samples = sampling.draw(engine, input, whole);
            return new Drawn(whole, samples, samples);
        }
        int fewest = sampling.samples();
        int most = 0;
        int bands = Math.ceilDiv(height, rowsPerBand);
        FrameTimes times = FrameTimes.NONE;
        Frame band = whole.ofRows(rowsPerBand);
        for (int drawn = 0; drawn < bands; drawn++) {
            progress.bands(engine.id(), drawn, bands);
            int first = drawn * rowsPerBand;
            int rows = Math.min(rowsPerBand, height - first);
            if (rows != band.height()) {
                band = whole.ofRows(rows);
            }
            int samples = sampling.draw(engine, input.band(input.firstRow() + first, rows), band);
            fewest = Math.min(fewest, samples);
            most = Math.max(most, samples);
            whole.put(band, first);
            times = times.plus(band.times());
        }
        progress.bands(engine.id(), bands, bands);
        whole.setTimes(times);
        return new Drawn(whole, fewest, most);
    }

    /** Bytes that drawing takes for each pixel of the picture; the bands come to less than as much again. */
    public static long bytesPerPixel(boolean linear) {
        return (linear ? CHANNELS : 1) * (long) Integer.BYTES;
    }

    private static int rowsPerBand(FrameInput input, int samplesPerPixel) {
        long rows = Math.max(MIN_ROWS, RAYS_PER_BAND / ((long) input.width() * samplesPerPixel)) / SQUARE * SQUARE;
        return (int) Math.min(rows, input.rows());
    }
}
