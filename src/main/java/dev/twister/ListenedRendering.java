package dev.twister;

import dev.twister.engine.ConvergingPicture;
import dev.twister.engine.Engine;
import dev.twister.image.RenderStoppedException;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;

/** Renders a picture in parts: passes of samples where there are enough, else bands of rows. */
final class ListenedRendering {
    /** Fewer samples give no estimate of the noise. */
    private static final int LEAST_SAMPLES = 8;

    private static final int BANDS = 16;

    /** Engines render squares of this side. */
    private static final int SQUARE = 16;

    private final Engine engine;
    private final FrameInput input;
    private final RenderListener listener;
    private final Frame frame;
    private double done;

    private ListenedRendering(Engine engine, FrameInput input, RenderListener listener) {
        this.engine = engine;
        this.input = input;
        this.listener = listener;
        frame = Frame.ofPixels(input.width(), input.rows());
        frame.stopWhen(listener::isCanceled);
    }

    /** The picture, or what there is of it once the thread is interrupted or the listener cancels. */
    static RenderedPicture render(Engine engine, FrameInput input, RenderListener listener, boolean srgb) {
        ListenedRendering rendering = new ListenedRendering(engine, input, listener);
        int samples = input.samplesPerPixel();
        try {
            // Passes have even numbers of samples; the points of an odd number are others.
            if (samples >= LEAST_SAMPLES && samples % 2 == 0) {
                rendering.renderPasses(samples);
            } else {
                rendering.renderBands(samples);
            }
        } catch (RenderStoppedException _) {
            return new RenderedPicture(rendering.frame, srgb, rendering.done);
        }
        return new RenderedPicture(rendering.frame, srgb);
    }

    private void renderPasses(int samples) {
        ConvergingPicture.draw(
                engine, input, frame, 0, samples, pass -> tell(pass.part(), pass.samples(), pass.noise()));
    }

    private void renderBands(int samples) {
        int rows = frame.height();
        int squares = Math.ceilDiv(rows, SQUARE);
        int bandRows = engine.drawsBandsInProportion() ? SQUARE * Math.ceilDiv(squares, BANDS) : rows;
        for (int first = 0; first < rows; first += bandRows) {
            Frame band = frame.ofRows(Math.min(bandRows, rows - first));
            try {
                engine.render(input.band(input.firstRow() + first, band.height()), band);
            } finally {
                frame.put(band, first);
            }
            tell((double) (first + band.height()) / rows, samples, 0);
        }
    }

    private void tell(double part, int samples, double noise) {
        done = part;
        listener.progress(part, samples, noise);
    }
}
