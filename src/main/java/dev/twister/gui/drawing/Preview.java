package dev.twister.gui.drawing;

import dev.twister.denoise.GuidedFilter;
import dev.twister.denoise.NoisyPicture;
import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import dev.twister.world.TonedPixels;
import java.nio.IntBuffer;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * The small picture that comes before a slow one. If it gathers samples, it is shown with more and more of them until
 * the full picture is begun: one sample of a path-traced picture is noise, a few are a picture. Used by one thread.
 */
final class Preview {
    /** A picture that takes longer is preceded by a smaller one. */
    static final long LONG_NANOS = TimeUnit.MILLISECONDS.toNanos(150);

    /** The time that the smaller one may take. */
    private static final long QUICK_NANOS = TimeUnit.MILLISECONDS.toNanos(60);

    private static final int MOST_DIVISOR = 8;
    private static final int MOST_DIVISOR_TRACED = 16;
    private static final int MOST_SAMPLES = 8;
    private static final int CHANNELS = 3;
    private static final int CLEAN_PIXELS = 120_000;

    /** Numbers of samples that pictures of a moving camera have, before they begin anew. */
    private static final int SAMPLE_NUMBERS = 4096;

    /** From the first sample on. */
    private static final long MOST_NANOS = TimeUnit.MILLISECONDS.toNanos(300);

    private final FrameInput input;
    private final Optional<RefinedPicture> gathered;
    private final Frame pass;
    private final Optional<SampleHistory> earlier;
    private final LongSupplier clock;
    private final long startNanos;
    private long renderNanos;
    private Optional<SampleHistory> history = Optional.empty();

    /** Of the view; empty until it is needed. */
    private Optional<float[]> distances = Optional.empty();

    private Preview(
            FrameInput input,
            Optional<RefinedPicture> gathered,
            Frame pass,
            Optional<SampleHistory> earlier,
            LongSupplier clock) {
        this.input = input;
        this.gathered = gathered;
        this.pass = pass;
        this.earlier = earlier;
        this.clock = clock;
        startNanos = clock.getAsLong();
    }

    /** A preview that is drawn once. */
    static Preview once(FrameInput input, LongSupplier clock) {
        return new Preview(input, Optional.empty(), Frame.ofPixels(1, 1), Optional.empty(), clock);
    }

    /**
     * A preview that gathers samples.
     *
     * @param input of the small size, with one sample per pixel
     * @param continuous whether one sample is enough, because the next picture shows another moment
     * @param denoised whether it is shown without its noise
     * @param earlier what was seen from where the camera was; counts only where it is denoised
     */
    static Preview gathering(
            FrameInput input,
            boolean continuous,
            boolean denoised,
            Optional<SampleHistory> earlier,
            LongSupplier clock) {
        int most = continuous ? 1 : MOST_SAMPLES;
        int layers = denoised ? input.withGuides().layers() : 0;
        return new Preview(
                input,
                Optional.of(new RefinedPicture(input.width(), input.height(), most, denoised)),
                Frame.ofRadiance(input.width(), input.height(), layers),
                earlier,
                clock);
    }

    /**
     * Divisor of the sides of the small picture: 1 if the full picture is fast enough or its time is unknown.
     *
     * @param nanos time of the full picture; 0 if unknown
     */
    static int divisor(long nanos, boolean traced) {
        int most = traced ? MOST_DIVISOR_TRACED : MOST_DIVISOR;
        int divisor = 1;
        while (nanos > LONG_NANOS && divisor < most && nanos / divisor / divisor > QUICK_NANOS) {
            divisor++;
        }
        return divisor;
    }

    /**
     * Divisor of the sides of a picture, so that it is filtered quickly.
     *
     * @param pixels of the picture
     */
    static int cleanDivisor(int pixels) {
        int divisor = 1;
        while (pixels / divisor / divisor > CLEAN_PIXELS) {
            divisor++;
        }
        return divisor;
    }

    /** The divisor for a picture that may take long, though nobody knows. */
    static int usualDivisor() {
        return MOST_DIVISOR;
    }

    FrameInput input() {
        return input;
    }

    /** Per pixel. */
    int samples() {
        return gathered.map(RefinedPicture::samples).orElse(input.samplesPerPixel());
    }

    /** Whether it is not worth another sample. */
    boolean isDone() {
        return gathered.filter(picture -> !picture.isDone() && clock.getAsLong() - startNanos <= MOST_NANOS)
                .isEmpty();
    }

    /** The engine's time for the last picture or sample, without what a filter takes. */
    long renderNanos() {
        return renderNanos;
    }

    /** What it shows, for pictures from elsewhere; empty if it is not denoised, or the engine takes long for that. */
    Optional<SampleHistory> history() {
        return history;
    }

    /**
     * Draws it, or adds one sample per pixel and shows all of them. If it is denoised, it adds as many as there are.
     */
    void draw(Engine engine, Frame shown) {
        if (gathered.isEmpty()) {
            render(engine, input, shown);
            return;
        }
        RefinedPicture picture = gathered.get();
        boolean denoised = pass.layerCount() > 0;
        // The filter may take longer than a sample.
        int goal = denoised ? 2 * picture.samples() : 0;
        int first = earlier.map(SampleHistory::nextSample).orElse(0) % SAMPLE_NUMBERS;
        do {
            FrameInput next = input.withSamples(first + picture.samples(), 1);
            render(engine, denoised ? next.withGuides() : next, pass);
            picture.add(pass, 1);
        } while (picture.samples() < goal && !isDone());
        if (denoised) {
            try (GuidedFilter filter = new GuidedFilter()) {
                TonedPixels.write(filter.denoise(noisy(engine, picture)), input, shown.argb());
            }
        } else {
            picture.show(input, IntBuffer.wrap(shown.argb()));
        }
        shown.setTimes(pass.times());
    }

    /** The samples, and those from where the camera was. */
    private NoisyPicture noisy(Engine engine, RefinedPicture picture) {
        if (!engine.drawsBandsInProportion()) {
            return picture.noisy();
        }
        if (distances.isEmpty()) {
            distances = Optional.of(distances(engine));
        }
        SampleHistory.View view = new SampleHistory.View(input, distances.get());
        history = Optional.of(new SampleHistory(view, picture.noisy(), picture.samples(), earlier));
        return earlier.isEmpty() ? picture.noisy() : history.get().noisy();
    }

    private float[] distances(Engine engine) {
        Frame depth = Frame.ofRadiance(input.width(), input.height(), 0);
        engine.render(input.withSamples(0, 1).showing(StageOrView.DEPTH), depth);
        float[] first = new float[input.width() * input.height()];
        for (int pixel = 0; pixel < first.length; pixel++) {
            first[pixel] = depth.radiance()[CHANNELS * pixel];
        }
        return first;
    }

    private void render(Engine engine, FrameInput drawn, Frame into) {
        long begin = clock.getAsLong();
        engine.render(drawn, into);
        renderNanos = clock.getAsLong() - begin;
    }
}
