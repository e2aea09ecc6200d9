package dev.twister.gui.drawing;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.NumberColors;
import dev.twister.gui.drawing.DrawnPicture.Gathered;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import dev.twister.world.TonedPixels;
import java.nio.IntBuffer;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BiPredicate;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * The steps from a request to its pictures: small ones right after the start, because nothing is compiled yet, then the
 * picture itself, then finer ones if there is no other request. Used only by the drawing thread.
 */
final class ProgressiveRenderer implements AutoCloseable {
    /** Divisor of the sides of the first picture. */
    private static final int COARSEST = 8;

    /** A picture with more is first drawn with these. */
    private static final int MOST_SAMPLES_AT_ONCE = 64;

    private static final int MOST_PREVIEW_SAMPLES = 4;

    /** A refined picture with fewer samples may look worse than the plain one. */
    private static final int FEWEST_REFINED_SAMPLES = 4;

    /** The same in path tracing, where the plain picture has one sample. */
    private static final int FEWEST_TRACED_SAMPLES = 2;

    /** A picture with fewer samples does not rest, however low its noise: it may lack light that few samples find. */
    private static final int FEWEST_CONVERGED_SAMPLES = 16;

    /** Time between two published pictures that hardly differ: publishing each would take time from drawing. */
    private static final long REFINED_EVERY_NANOS = TimeUnit.MILLISECONDS.toNanos(50);

    /** A picture that takes longer is not drawn again only because another engine is about to be ready. */
    private static final long SLOW_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final PictureExchange exchange;
    private final LongSupplier clock;
    private final Supplier<Optional<DrawingRequest>> newest;
    private final BandRenderer bands;
    private final CurrentWorld world;
    private final ActiveEngine engines;
    private final BackgroundDenoising denoising;
    private FrameInput input;
    private Optional<String> sceneFailure = Optional.empty();
    private Optional<DrawingRequest> request = Optional.empty();
    private boolean drawn;

    /** The smaller picture that has answered the request. */
    private Optional<Preview> preview = Optional.empty();

    /** What was seen from where the camera was before. */
    private Optional<SampleHistory> history = Optional.empty();

    private int coarseness = COARSEST;
    private Optional<Engine> drawer = Optional.empty();
    private Optional<RefinedPicture> refined = Optional.empty();

    /** The sky's version in the gathered samples: its file may have been read again since. */
    private float[] refinedSky = {};

    private Optional<Frame> pass = Optional.empty();
    private long pictures;
    private Optional<DrawnPicture> last = Optional.empty();
    private volatile Optional<Consumer<DrawnPicture>> watcher = Optional.empty();

    /**
     * @param newest the newest request; empty if nothing is to be drawn
     * @param whenReady called on another thread when an answered request may have new work
     */
    ProgressiveRenderer(
            PictureExchange exchange,
            ImageCache skies,
            MeshCache meshes,
            EngineOffer substitute,
            Supplier<Optional<DrawingRequest>> newest,
            Runnable whenReady,
            LongSupplier clock) {
        this.clock = clock;
        this.newest = newest;
        bands = new BandRenderer(clock);
        this.exchange = exchange;
        world = new CurrentWorld(skies, meshes, () -> newest.get().map(DrawingRequest::scene));
        engines = new ActiveEngine(substitute, whenReady);
        denoising = new BackgroundDenoising(whenReady);
    }

    /**
     * Brings the world up to date with a request and starts opening its engine; returns whether there is something to
     * draw.
     */
    boolean prepare(DrawingRequest wanted) {
        try {
            input = showing(wanted.shown(), world.snapshot(wanted, clock.getAsLong()));
            engines.choose(wanted.engine(), new WarmUp(input, coarse(COARSEST), clock));
            sceneFailure = Optional.empty();
        } catch (OutOfMemoryError _) {
            sceneFailure = Optional.of("there is not enough memory for this scene");
        } catch (RuntimeException | Error problem) {
            sceneFailure = Optional.of("this scene cannot be drawn: " + problem);
        }
        return sceneFailure.isEmpty();
    }

    /** Numbers need one sample: the mean of two bodies' numbers is the number of a third. */
    private FrameInput showing(StageOrView shown, FrameInput input) {
        FrameInput seen = shown == StageOrView.BEAUTY ? input : input.showing(shown);
        if (!shown.isColor()) {
            return seen.withSamples(0, 1);
        }
        // At rest, more samples are gathered. One of a path takes long.
        int most = shown == StageOrView.BEAUTY && input.tracesPaths() ? 1 : MOST_SAMPLES_AT_ONCE;
        return watcher.isEmpty() && seen.samplesPerPixel() > most ? seen.withSamples(0, most) : seen;
    }

    /** Takes one step for the prepared request; returns whether there is another. */
    boolean step(DrawingRequest wanted) {
        Engine engine = engines.engine();
        if (!isAtWork(wanted) || !drawer.equals(Optional.of(engine)) || engines.hasBecomeFaster()) {
            boolean toned = hasItsSamples(wanted, engine);
            boolean otherDenoiser = !request.flatMap(this::denoiser).equals(denoiser(wanted));
            history = seenBefore(wanted);
            drawn = toned || (drawn && isSlowAndTheSame(wanted, engine));
            request = Optional.of(wanted);
            drawer = Optional.of(engine);
            if (toned) {
                if (otherDenoiser) {
                    denoising.retry();
                }
                showRefined(wanted, engine);
                return true;
            }
            refined = refined.filter(old -> old.fits(wanted.width(), wanted.height()));
            refined.ifPresent(RefinedPicture::reset);
            denoising.reset();
            preview = Optional.empty();
        }
        try {
            return draw(wanted, engine);
        } catch (RuntimeException | Error problem) {
            boolean hopeless = engines.isSubstituted();
            refined = Optional.empty();
            pass = Optional.empty();
            engines.giveUp(problem);
            return !hopeless;
        }
    }

    /** What was seen from elsewhere, if nothing but the camera's place and direction differs. */
    @SuppressWarnings("ReferenceEquality") // another array means that the file was read anew
    private Optional<SampleHistory> seenBefore(DrawingRequest wanted) {
        return preview.flatMap(Preview::history)
                .or(() -> history)
                .filter(seen -> seen.images() == input.images()
                        && !wanted.isContinuous()
                        && request.filter(wanted::looksFromElsewhereThan).isPresent());
    }

    /** Called after some time without a request. */
    void rest() {
        engines.rest();
    }

    private boolean isAtWork(DrawingRequest wanted) {
        return request.filter(old -> old.number() == wanted.number()).isPresent();
    }

    /** Whether the gathered samples are those of the request. */
    @SuppressWarnings("ReferenceEquality") // another array means that the file was read anew
    private boolean hasItsSamples(DrawingRequest wanted, Engine engine) {
        return drawn
                && !wanted.isContinuous()
                && drawer.equals(Optional.of(engine))
                && !engines.hasBecomeFaster()
                && request.filter(wanted::asksForTheSamplesOf).isPresent()
                && refinedSky == input.images()
                && refined.filter(held -> held.samples() >= FEWEST_REFINED_SAMPLES)
                        .isPresent();
    }

    /** Whether the request differs only in the engine, and the old one would take long for its picture. */
    private boolean isSlowAndTheSame(DrawingRequest wanted, Engine engine) {
        return drawer.equals(Optional.of(engine))
                && request.filter(wanted::asksForThePictureOf).isPresent()
                && bands.knownNanos(engine, input) > SLOW_NANOS;
    }

    /** The samples gathered for that picture; empty if it was not refined or another request has begun. */
    Optional<float[]> radiance(DrawnPicture picture) {
        return refined.filter(held -> isAtWork(picture.request())
                        && held.fits(picture.frame().width(), picture.frame().height())
                        && held.samples() > picture.input().samplesPerPixel()
                        && held.samples() >= picture.samples())
                .map(held -> clean(picture.request())
                        .map(BackgroundDenoising.Clean::radiance)
                        .orElseGet(held::radiance));
    }

    /** Sets the watcher that gets each whole picture; called by any thread. */
    void watch(Optional<Consumer<DrawnPicture>> newWatcher) {
        watcher = newWatcher;
    }

    DrawingLoop.Status status() {
        return new DrawingLoop.Status(
                engines.opening(),
                engines.failure()
                        .or(() -> request.filter(wanted -> denoiser(wanted).isPresent())
                                .flatMap(_ -> denoising.failure())),
                sceneFailure.or(world::complaint));
    }

    @Override
    public void close() {
        engines.close();
        denoising.close();
        world.close();
    }

    private boolean draw(DrawingRequest wanted, Engine engine) {
        // While another engine is being opened, repeating a picture is not worth the processor's time.
        boolean opening = engines.opening().isPresent();
        if (isPreview(wanted) && drawQuickly(wanted, engine)) {
            return true;
        }
        if (coarseness > 1 && engines.isSubstituted()) {
            FrameInput small = coarse(coarseness);
            if (cleans(wanted)) {
                drawPreview(wanted, engine, Preview.gathering(small, true, true, Optional.empty(), clock));
            } else {
                drawPlain(wanted, engine, small, false);
            }
            coarseness /= 2;
            return true;
        }
        if (!drawn && preview.isEmpty() && drawQuickly(wanted, engine)) {
            return true;
        }
        if (!drawn && preview.filter(small -> !small.isDone()).isPresent()) {
            drawPreview(wanted, engine, preview.orElseThrow());
            return true;
        }
        if (!drawn && !wanted.isContinuous() && cleans(wanted)) {
            // The small picture stays until the full one has no noise either.
            drawn = true;
            coarseness = 1;
            return true;
        }
        if (!drawn || (wanted.isContinuous() && !opening)) {
            if (drawPlain(wanted, engine, input, drawn && !wanted.motion().running())) {
                drawn = true;
                coarseness = 1;
                return !opening;
            }
            return true;
        }
        if (opening || wanted.isContinuous()) {
            return false;
        }
        return refine(wanted, engine);
    }

    /** Whether only smaller pictures are drawn if full ones take long: bodies move in path tracing. */
    private boolean isPreview(DrawingRequest wanted) {
        return wanted.motion().running() && input.tracesPaths() && watcher.isEmpty();
    }

    /** Draws a smaller picture first if the full one is known to take long; returns whether it was drawn. */
    private boolean drawQuickly(DrawingRequest wanted, Engine engine) {
        boolean unknown = bands.mayTakeLong(engine, input);
        int fast = unknown
                ? Preview.usualDivisor()
                : Preview.divisor(bands.knownNanos(engine, input), input.tracesPaths());
        int divisor = Math.max(fast, cleans(wanted) ? Preview.cleanDivisor(input.width() * input.height()) : 1);
        if (divisor == 1) {
            return false;
        }
        FrameInput sized = coarse(divisor);
        FrameInput small =
                sized.samplesPerPixel() > MOST_PREVIEW_SAMPLES ? sized.withSamples(0, MOST_PREVIEW_SAMPLES) : sized;
        boolean gathers = input.tracesPaths() && wanted.shown() == StageOrView.BEAUTY && watcher.isEmpty();
        Preview drawing = gathers
                ? Preview.gathering(small, wanted.isContinuous(), cleans(wanted), history, clock)
                : Preview.once(small, clock);
        preview = Optional.of(drawing);
        drawPreview(wanted, engine, drawing);
        if (unknown || isPreview(wanted)) {
            int parts = divisor * divisor * input.samplesPerPixel() / small.samplesPerPixel();
            bands.guess(engine, input, drawing.renderNanos() * parts);
        }
        return true;
    }

    private void drawPreview(DrawingRequest wanted, Engine engine, Preview drawing) {
        BiPredicate<FrameInput, Frame> renderer = (_, pixels) -> {
            drawing.draw(engine, pixels);
            return true;
        };
        drawFrame(wanted, engine, drawing.input(), renderer, drawing::samples, false);
    }

    private FrameInput coarse(int divisor) {
        return input.withSize(Math.ceilDiv(input.width(), divisor), Math.ceilDiv(input.height(), divisor));
    }

    /** Draws the picture; returns whether it was finished. */
    private boolean drawPlain(DrawingRequest wanted, Engine engine, FrameInput seen, boolean again) {
        BiPredicate<FrameInput, Frame> renderer =
                (input, pixels) -> bands.draw(engine, input, pixels, nanosLeft -> isInVain(wanted, nanosLeft));
        return drawFrame(wanted, engine, seen, renderer, seen::samplesPerPixel, again);
    }

    /** Draws a picture of any size and shows it; returns whether it was finished. */
    private boolean drawFrame(
            DrawingRequest wanted,
            Engine engine,
            FrameInput seen,
            BiPredicate<FrameInput, Frame> renderer,
            IntSupplier samples,
            boolean again) {
        Frame frame = exchange.frameToDraw(seen.width(), seen.height());
        boolean whole = false;
        try {
            whole = render(wanted, seen, frame, renderer);
        } finally {
            if (!whole) {
                exchange.abandon(frame);
            }
        }
        if (whole) {
            finish(wanted, seen, engine, frame, frame.times(), Gathered.of(samples.getAsInt()), again);
        }
        return whole;
    }

    /** Draws a view of numbers, then turns them into colors. */
    private boolean render(
            DrawingRequest wanted, FrameInput seen, Frame frame, BiPredicate<FrameInput, Frame> renderer) {
        if (wanted.shown().isColor()) {
            return renderer.test(seen, frame);
        }
        Frame linear = linear(seen.width(), seen.height(), 0);
        boolean whole = renderer.test(seen, linear);
        if (whole) {
            NumberColors.paint(wanted.shown(), linear.radiance(), frame.argb());
            frame.setTimes(linear.times());
        }
        return whole;
    }

    private Frame linear(int width, int height, int layers) {
        Frame linear = pass.filter(old -> old.width() == width && old.height() == height && old.layerCount() == layers)
                .orElseGet(() -> Frame.ofRadiance(width, height, layers));
        pass = Optional.of(linear);
        return linear;
    }

    /**
     * Whether to abandon a picture: another engine is ready or about to draw, another size is requested, or the request
     * looks entirely different and the rest takes long. Pictures of a moving camera or a dragged body are finished,
     * unless smaller ones of them are shown.
     */
    private boolean isInVain(DrawingRequest wanted, long nanosLeft) {
        return engines.isReady()
                || (preview.isPresent()
                        && nanosLeft > Preview.LONG_NANOS
                        && newest.get().filter(this::isAtWork).isEmpty())
                || newest.get()
                        .filter(request -> request.engine().equals(wanted.engine())
                                && request.width() == wanted.width()
                                && request.height() == wanted.height()
                                && (nanosLeft < SLOW_NANOS || request.showsThePlaceOf(wanted)))
                        .isEmpty();
    }

    private boolean refine(DrawingRequest wanted, Engine engine) {
        RefinedPicture picture = refining(wanted);
        boolean done = isDone(picture, wanted);
        Optional<DenoiserOffer> denoiser = denoiser(wanted);
        if (denoiser.isPresent() && denoising.advance(picture, done, denoiser.get())) {
            showRefined(wanted, engine);
        }
        if (done) {
            return false;
        }
        // At the limit, single samples follow until the guides have enough.
        int samples = Math.max(1, picture.samplesOfNextPass(input.samplesPerPixel()));
        FrameInput plain = picture.next(input, samples);
        FrameInput next = denoiser.isPresent() ? plain.withGuides() : plain;
        Frame linear = linear(wanted.width(), wanted.height(), next.layers());
        if (!bands.draw(engine, next, linear, _ -> isRefinedInVain())) {
            return true;
        }
        picture.add(linear, samples);
        boolean last = isDone(picture, wanted);
        // Its noise would be seen for a moment.
        if (last || (!cleans(wanted) && picture.samples() >= fewestRefined() && isToBeSeen())) {
            showRefined(wanted, engine);
        } else {
            pictures++;
        }
        return !last || denoiser.isPresent();
    }

    /** The samples gathered so far for a request, or none. */
    private RefinedPicture refining(DrawingRequest wanted) {
        int limit = wanted.refinement().samples();
        boolean traced = input.tracesPaths();
        RefinedPicture picture = refined.filter(old -> old.limit() == limit && old.isEstimated() == traced)
                .orElseGet(() -> {
                    denoising.reset();
                    return new RefinedPicture(wanted.width(), wanted.height(), limit, traced);
                });
        refined = Optional.of(picture);
        refinedSky = input.images();
        return picture;
    }

    private Optional<DenoiserOffer> denoiser(DrawingRequest wanted) {
        return wanted.refinement().denoiser().filter(_ -> input.tracesPaths() && wanted.shown() == StageOrView.BEAUTY);
    }

    /** Whether no picture with noise is shown. */
    private boolean cleans(DrawingRequest wanted) {
        return denoiser(wanted).isPresent()
                && watcher.isEmpty()
                && denoising.failure().isEmpty();
    }

    /** The picture without its noise, if that is wanted. */
    private Optional<BackgroundDenoising.Clean> clean(DrawingRequest wanted) {
        return denoiser(wanted).flatMap(_ -> denoising.newest());
    }

    /**
     * Whether the picture has all its samples, or its noise is below the goal. One that is denoised from now on gets
     * some more, with guides.
     */
    private boolean isDone(RefinedPicture picture, DrawingRequest wanted) {
        double goal = wanted.refinement().noise();
        boolean low = goal > 0
                && picture.samples() >= FEWEST_CONVERGED_SAMPLES
                && picture.noise(input).orElse(Double.MAX_VALUE) <= goal;
        return (picture.isDone() || low) && !(denoiser(wanted).isPresent() && picture.lacksGuides());
    }

    private int fewestRefined() {
        return input.tracesPaths() ? FEWEST_TRACED_SAMPLES : FEWEST_REFINED_SAMPLES;
    }

    private void showRefined(DrawingRequest wanted, Engine engine) {
        RefinedPicture picture = refined.orElseThrow();
        Frame frame = exchange.frameToDraw(wanted.width(), wanted.height());
        Optional<BackgroundDenoising.Clean> clean = clean(wanted);
        if (clean.isPresent()) {
            TonedPixels.write(clean.get().radiance(), input, frame.argb());
        } else if (wanted.shown().isColor()) {
            picture.show(input, IntBuffer.wrap(frame.argb()));
        } else {
            NumberColors.paint(wanted.shown(), picture.radiance(), frame.argb());
        }
        FrameTimes times = pass.map(Frame::times).orElse(FrameTimes.NONE);
        Gathered gathered = new Gathered(
                clean.map(BackgroundDenoising.Clean::samples).orElseGet(picture::samples),
                picture.noise(input),
                clean.isPresent(),
                isDone(picture, wanted) && (denoiser(wanted).isEmpty() || denoising.isDone(picture)));
        finish(wanted, input, engine, frame, times, gathered, false);
    }

    /** Whether to abandon a refining pass: any new request counts, because a pass is not shown by itself. */
    private boolean isRefinedInVain() {
        return engines.isReady() || newest.get().filter(this::isAtWork).isEmpty();
    }

    /** Whether to publish the samples gathered so far: a watcher gets all pictures, the window a few per second. */
    private boolean isToBeSeen() {
        return watcher.isPresent()
                || last.filter(old -> isAtWork(old.request())
                                && old.samples() >= fewestRefined()
                                && clock.getAsLong() - old.finishedNanos() < REFINED_EVERY_NANOS)
                        .isEmpty();
    }

    private void finish(
            DrawingRequest wanted,
            FrameInput seen,
            Engine engine,
            Frame frame,
            FrameTimes times,
            Gathered gathered,
            boolean again) {
        pictures++;
        // The engine may have switched during the call that drew.
        long original = last.filter(old -> again
                        && old.engine().equals(engine.id())
                        && old.device().equals(engine.device()))
                .map(DrawnPicture::original)
                .orElse(pictures);
        DrawnPicture picture = new DrawnPicture(
                frame,
                wanted,
                seen,
                world.meshes(),
                engine.id(),
                engine.device(),
                times,
                gathered,
                pictures,
                original,
                clock.getAsLong());
        last = Optional.of(picture);
        exchange.finished(picture);
        if (picture.isWhole()) {
            // Shown or not, its pixels stay valid: only this thread draws over them.
            watcher.ifPresent(eye -> eye.accept(picture));
        }
    }
}
