package dev.twister.render;

import dev.twister.world.FrameInput;
import java.util.List;
import java.util.Optional;

/**
 * What a rendering did.
 *
 * @param kept number of frames of an earlier run that were kept
 * @param samples of the pictures that were rendered, if there was a noise bound
 * @param picture empty for frames and films
 */
public record RenderResult(int kept, Samples samples, Optional<Single> picture) {
    /**
     * A single picture.
     *
     * @param part the rows and samples that were rendered
     * @param engine its id
     * @param device its display name
     */
    public record Single(List<RenderedView> drawn, FrameInput part, String engine, String device) {}

    /**
     * Samples per pixel of pictures with a noise bound.
     *
     * @param fewest of any pixel
     * @param most of any pixel
     * @param sum over all pixels
     * @param pixels number of them; 0 if there was no noise bound
     * @param noise of the noisiest part of any picture
     */
    public record Samples(double fewest, double most, double sum, long pixels, double noise) {
        static final Samples NONE = new Samples(Double.MAX_VALUE, 0, 0, 0, 0);

        /** With the samples of one more picture. */
        Samples plus(BandedDrawing.Drawn drawn) {
            double least = fewest;
            double largest = most;
            double all = sum;
            for (float samples : drawn.samples()) {
                least = Math.min(least, samples);
                largest = Math.max(largest, samples);
                all += samples;
            }
            return new Samples(least, largest, all, pixels + drawn.samples().length, Math.max(noise, drawn.noise()));
        }

        /** Of all pixels. */
        public double average() {
            return sum / pixels;
        }
    }
}
