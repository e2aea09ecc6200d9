package dev.twister.render;

/**
 * Samples per pixel of pictures with a noise bound.
 *
 * @param fewest of any pixel
 * @param most of any pixel
 * @param sum over all pixels
 * @param pixels number of them; 0 if there was no noise bound
 * @param noise of the noisiest part of any picture
 */
public record SampleTotals(double fewest, double most, double sum, long pixels, double noise) {
    static final SampleTotals NONE = new SampleTotals(Double.MAX_VALUE, 0, 0, 0, 0);

    /** With the samples of one more picture. */
    SampleTotals plus(BandedDrawing.Drawn drawn) {
        double least = fewest;
        double largest = most;
        double all = sum;
        for (float samples : drawn.samples()) {
            least = Math.min(least, samples);
            largest = Math.max(largest, samples);
            all += samples;
        }
        return new SampleTotals(least, largest, all, pixels + drawn.samples().length, Math.max(noise, drawn.noise()));
    }

    /** Of all pixels. */
    public double average() {
        return sum / pixels;
    }
}
