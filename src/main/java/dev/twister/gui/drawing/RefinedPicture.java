package dev.twister.gui.drawing;

import dev.twister.denoise.NoisyPicture;
import dev.twister.denoise.Plane;
import dev.twister.engine.NoiseEstimate;
import dev.twister.engine.NoiseEstimate.Half;
import dev.twister.image.Frame;
import dev.twister.kernel.Guides;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.world.FrameInput;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * A picture at rest that gets better: the samples of each pass are added to those before, so that the picture after
 * passes of n1, n2, ... samples is the one of {@code withSamples(0, n1 + n2 + ...)}, rounding aside. Used by one
 * thread.
 *
 * <p>A pass is {@code engine.render(picture.next(input, n), linearFrame)}, then {@code picture.add(linearFrame, n)}.
 */
public final class RefinedPicture {
    private static final int CHANNELS = 3;

    /** Number of samples from which guides have smooth edges. */
    private static final int ENOUGH_GUIDED = 16;

    private final int width;
    private final int height;
    private final int limit;
    private final float[] sums;

    /** Of every second pass if the noise is estimated, else empty. */
    private final float[] otherSums;

    /** Albedo, then normals, of the passes that had guides; empty before the first of them. */
    private float[] guideSums = {};

    private int guidedSamples;

    private int samples;
    private int otherSamples;
    private int passes;
    private Optional<Estimate> estimate = Optional.empty();
    private double noise;

    /**
     * An empty picture.
     *
     * @param limit the samples a pixel at which it is done, 1 or more
     * @param estimated whether to estimate the noise, which takes twice the memory
     */
    public RefinedPicture(int width, int height, int limit, boolean estimated) {
        this.width = width;
        this.height = height;
        this.limit = limit;
        sums = new float[Math.multiplyExact(CHANNELS, Math.multiplyExact(width, height))];
        otherSums = new float[estimated ? sums.length : 0];
    }

    /** Restarts: the scene, the camera or a setting that changes radiance has changed. */
    public void reset() {
        Arrays.fill(sums, 0);
        Arrays.fill(otherSums, 0);
        Arrays.fill(guideSums, 0);
        samples = 0;
        guidedSamples = 0;
        otherSamples = 0;
        passes = 0;
        estimate = Optional.empty();
    }

    /** What an estimate of the noise depends on, of one picture. */
    private record Estimate(int samples, float exposureScale, float toneMap, float srgb) {}

    /** The samples a pixel so far. */
    public int samples() {
        return samples;
    }

    public int limit() {
        return limit;
    }

    /** Whether the noise is estimated. */
    public boolean isEstimated() {
        return otherSums.length > 0;
    }

    /** The samples per pixel of the passes that had guides. */
    public int guidedSamples() {
        return guidedSamples;
    }

    /** Whether more samples with guides make them better: those of few samples have hard edges. */
    public boolean lacksGuides() {
        return guidedSamples < Math.min(samples, ENOUGH_GUIDED);
    }

    public boolean isDone() {
        return samples >= limit;
    }

    public boolean fits(int pictureWidth, int pictureHeight) {
        return width == pictureWidth && height == pictureHeight;
    }

    /** How many samples a pass of at most that many has: fewer at the limit. */
    public int samplesOfNextPass(int most) {
        return Math.min(most, limit - samples);
    }

    /** What the next pass is to draw; with {@link FrameInput#withGuides} if the picture is to be denoised. */
    public FrameInput next(FrameInput input, int passSamples) {
        return input.withSamples(samples, passSamples);
    }

    /**
     * Adds a pass.
     *
     * @param pass linear, drawn from {@link #next} of as many samples, with guides or without
     * @throws IllegalArgumentException if the frame is not linear, has another size or other layers
     */
    public void add(Frame pass, int passSamples) {
        boolean guided = pass.layerCount() == Guides.LAYERS;
        if (!pass.isLinear() || !fits(pass.width(), pass.height()) || (pass.layerCount() > 0 && !guided)) {
            throw new IllegalArgumentException("a pass must be linear, " + width + " x " + height
                    + " pixels, without layers or with guides, not " + pass.width() + " x " + pass.height() + " with "
                    + pass.layerCount() + " layers");
        }
        float[] radiance = pass.radiance();
        boolean other = isEstimated() && passes % 2 == 1;
        float[] half = other ? otherSums : sums;
        rows().forEach(row -> {
            int end = CHANNELS * width * (row + 1);
            for (int i = CHANNELS * width * row; i < end; i++) {
                half[i] += passSamples * radiance[i];
            }
        });
        if (guided) {
            addGuides(pass.layers(), passSamples);
        }
        samples += passSamples;
        otherSamples += other ? passSamples : 0;
        passes++;
    }

    private void addGuides(float[] guides, int passSamples) {
        guideSums = guideSums.length > 0 ? guideSums : new float[guides.length];
        for (int i = 0; i < guides.length; i++) {
            guideSums[i] += passSamples * guides[i];
        }
        guidedSamples += passSamples;
    }

    /**
     * The estimated noise, relative to white; see {@link NoiseEstimate}. Empty if it is not estimated, or before the
     * second pass.
     *
     * @param input whose exposure, tone map and sRGB curve count
     */
    public OptionalDouble noise(FrameInput input) {
        if (otherSamples == 0) {
            return OptionalDouble.empty();
        }
        float[] frame = input.view().frame();
        Estimate wanted =
                new Estimate(samples, frame[Layout.EXPOSURE_SCALE], frame[Layout.TONE_MAP], frame[Layout.SRGB]);
        if (!estimate.equals(Optional.of(wanted))) {
            estimate = Optional.of(wanted);
            noise = new NoiseEstimate(width, frame)
                    .of(new Half(sums, samples - otherSamples), new Half(otherSums, otherSamples));
        }
        return OptionalDouble.of(noise);
    }

    /**
     * Tone-maps the picture so far as the kernel does.
     *
     * @param input whose exposure, tone map and sRGB curve count, and nothing else
     * @param argb receives 0xAARRGGBB, row by row from the top, from index 0 on
     * @throws IllegalStateException if no pass was added yet
     */
    public void show(FrameInput input, IntBuffer argb) {
        if (samples == 0) {
            throw new IllegalStateException("there is no pass to show");
        }
        float[] values = input.view().frame();
        float exposureScale = values[Layout.EXPOSURE_SCALE];
        int toneMap = (int) values[Layout.TONE_MAP];
        float srgb = values[Layout.SRGB];
        float average = 1f / samples;
        rows().forEach(row -> {
            int end = width * (row + 1);
            for (int pixel = width * row; pixel < end; pixel++) {
                int at = CHANNELS * pixel;
                argb.put(
                        pixel,
                        Tone.OPAQUE
                                | (Tone.quantized(sum(at) * average, exposureScale, toneMap, srgb) << 16)
                                | (Tone.quantized(sum(at + 1) * average, exposureScale, toneMap, srgb) << 8)
                                | Tone.quantized(sum(at + 2) * average, exposureScale, toneMap, srgb));
            }
        });
    }

    /** The linear picture so far, as {@link Frame#radiance} has it. */
    public float[] radiance() {
        float average = samples == 0 ? 0 : 1f / samples;
        float[] radiance = new float[sums.length];
        rows().forEach(row -> {
            int end = CHANNELS * width * (row + 1);
            for (int i = CHANNELS * width * row; i < end; i++) {
                radiance[i] = sum(i) * average;
            }
        });
        return radiance;
    }

    /** The picture so far with its guides; there must be samples with guides. */
    public NoisyPicture noisy() {
        float[] guides = new float[guideSums.length];
        for (int i = 0; i < guides.length; i++) {
            guides[i] = guideSums[i] / guidedSamples;
        }
        return new NoisyPicture(
                width,
                height,
                new Plane(radiance(), 0),
                Optional.of(new NoisyPicture.Guides(new Plane(guides, 0), new Plane(guides, sums.length))),
                noise());
    }

    /** The difference of the two halves, as far from 0 as the picture is from its limit; empty before the second. */
    private Optional<NoisyPicture.Noise> noise() {
        if (otherSamples == 0) {
            return Optional.empty();
        }
        int firstSamples = samples - otherSamples;
        float scale = (float) Math.sqrt((double) firstSamples * otherSamples) / samples;
        float[] difference = new float[sums.length];
        for (int i = 0; i < difference.length; i++) {
            difference[i] = scale * (sums[i] / firstSamples - otherSums[i] / otherSamples);
        }
        return Optional.of(new NoisyPicture.Noise(new Plane(difference, 0), samples));
    }

    private float sum(int value) {
        return otherSums.length > 0 ? sums[value] + otherSums[value] : sums[value];
    }

    private IntStream rows() {
        return IntStream.range(0, height).parallel();
    }
}
