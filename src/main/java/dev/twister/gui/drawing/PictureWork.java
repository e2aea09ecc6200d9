package dev.twister.gui.drawing;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.gui.model.RefinedPicture;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.nio.IntBuffer;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * The steps from a request to its pictures: at the very start small ones, because nothing is compiled yet, then the picture
 * itself, then, where nothing else is asked for, finer ones. Used by the drawing thread alone.
 */
final class PictureWork implements AutoCloseable {
    /** What the sides of the first picture are divided by. */
    private static final int COARSEST = 8;

    /** A refined picture of fewer samples may look worse than the plain one. */
    private static final int FEWEST_REFINED_SAMPLES = 4;

    /** Between two pictures that differ by less than one sees: to show each would take time from their drawing. */
    private static final long REFINED_EVERY_NANOS = TimeUnit.MILLISECONDS.toNanos(50);

    private final PictureExchange exchange;
    private final LongSupplier clock;
    private final LivingWorld world;
    private final EngineSeat seat;
    private FrameInput input;
    private Optional<String> sceneFailure = Optional.empty();
    private long request = Long.MIN_VALUE;
    private boolean drawn;
    private int coarseness = COARSEST;
    private Optional<Engine> drawer = Optional.empty();
    private Optional<RefinedPicture> refined = Optional.empty();
    private Optional<Frame> pass = Optional.empty();
    private long pictures;
    private Optional<DrawnPicture> last = Optional.empty();
    private volatile Optional<Consumer<DrawnPicture>> watcher = Optional.empty();

    PictureWork(
            PictureExchange exchange, SkyShelf skies, EngineOffer substitute, Runnable whenReady, LongSupplier clock) {
        this.clock = clock;
        this.exchange = exchange;
        world = new LivingWorld(skies);
        seat = new EngineSeat(substitute, whenReady);
    }

    /** Looks at a request: the world is as it says, and its engine is being opened. Whether there is something to draw. */
    boolean prepare(DrawingRequest wanted) {
        try {
            input = world.snapshot(wanted.scene(), wanted.motion(), wanted.width(), wanted.height(), clock.getAsLong());
            seat.choose(wanted.engine(), new WarmUp(input, coarse(COARSEST)));
            sceneFailure = Optional.empty();
        } catch (OutOfMemoryError _) {
            sceneFailure = Optional.of("there is not enough memory for this scene");
        } catch (RuntimeException | Error problem) {
            sceneFailure = Optional.of("this scene cannot be drawn: " + problem);
        }
        return sceneFailure.isEmpty();
    }

    /** Takes one step for the request that was prepared; whether there is another to take. */
    boolean step(DrawingRequest wanted) {
        Engine engine = seat.engine();
        if (wanted.number() != request || !drawer.equals(Optional.of(engine)) || seat.hasBecomeFaster()) {
            request = wanted.number();
            drawer = Optional.of(engine);
            drawn = false;
            refined = refined.filter(old -> old.fits(wanted.width(), wanted.height()));
            refined.ifPresent(RefinedPicture::reset);
        }
        try {
            return draw(wanted, engine);
        } catch (RuntimeException | Error problem) {
            boolean hopeless = seat.isSubstituted();
            refined = Optional.empty();
            pass = Optional.empty();
            seat.giveUp(problem);
            return !hopeless;
        }
    }

    /** What was gathered for that picture; empty where it was not refined, or another request is at work by now. */
    Optional<float[]> radiance(DrawnPicture picture) {
        return refined.filter(held -> picture.request().number() == request
                        && held.fits(picture.frame().width(), picture.frame().height())
                        && held.samples() > picture.request().scene().settings().samplesPerPixel()
                        && held.samples() >= picture.samples())
                .map(RefinedPicture::radiance);
    }

    /** From now on each whole picture is handed to that, where there is one; called by any thread. */
    void watch(Optional<Consumer<DrawnPicture>> newWatcher) {
        watcher = newWatcher;
    }

    DrawingStatus status() {
        return new DrawingStatus(seat.opening(), seat.failure(), sceneFailure.or(world::complaint));
    }

    @Override
    public void close() {
        seat.close();
        world.close();
    }

    private boolean draw(DrawingRequest wanted, Engine engine) {
        // While another engine is made ready, a picture that is there already is not worth the processor's time.
        boolean opening = seat.opening().isPresent();
        if (coarseness > 1 && seat.isSubstituted()) {
            drawPlain(wanted, engine, coarse(coarseness), false);
            coarseness /= 2;
            return true;
        }
        if (!drawn || (wanted.isContinuous() && !opening)) {
            drawPlain(wanted, engine, input, drawn && !wanted.motion().running());
            drawn = true;
            coarseness = 1;
            return !opening;
        }
        if (opening || wanted.isContinuous()) {
            return false;
        }
        return refine(wanted, engine);
    }

    private FrameInput coarse(int divisor) {
        return input.withSize(Math.ceilDiv(input.width(), divisor), Math.ceilDiv(input.height(), divisor));
    }

    private void drawPlain(DrawingRequest wanted, Engine engine, FrameInput seen, boolean again) {
        Frame frame = exchange.frameToDraw(seen.width(), seen.height());
        try {
            engine.render(seen, frame);
        } catch (RuntimeException | Error problem) {
            exchange.abandon(frame);
            throw problem;
        }
        finish(wanted, seen, engine, frame, frame.times(), seen.samplesPerPixel(), again);
    }

    private boolean refine(DrawingRequest wanted, Engine engine) {
        RefinedPicture picture = refined.filter(old -> old.limit() == wanted.refineTo())
                .orElseGet(() -> new RefinedPicture(wanted.width(), wanted.height(), wanted.refineTo()));
        refined = Optional.of(picture);
        if (picture.isDone()) {
            return false;
        }
        Frame linear = pass.filter(old -> picture.fits(old.width(), old.height()))
                .orElseGet(() -> Frame.ofRadiance(wanted.width(), wanted.height()));
        pass = Optional.of(linear);
        int samples = picture.samplesOfNextPass(input.samplesPerPixel());
        engine.render(picture.next(input, samples), linear);
        picture.add(linear, samples);
        if (picture.isDone() || (picture.samples() >= FEWEST_REFINED_SAMPLES && isToBeSeen())) {
            Frame frame = exchange.frameToDraw(wanted.width(), wanted.height());
            picture.show(input, IntBuffer.wrap(frame.argb()));
            finish(wanted, input, engine, frame, linear.times(), picture.samples(), false);
        } else {
            pictures++;
        }
        return !picture.isDone();
    }

    /** Whether what was gathered is worth a picture now: whoever watches sees all, a person some in a second. */
    private boolean isToBeSeen() {
        return watcher.isPresent()
                || last.filter(old -> old.request().number() == request
                                && old.samples() >= FEWEST_REFINED_SAMPLES
                                && clock.getAsLong() - old.finishedNanos() < REFINED_EVERY_NANOS)
                        .isEmpty();
    }

    private void finish(
            DrawingRequest wanted,
            FrameInput seen,
            Engine engine,
            Frame frame,
            FrameTimes times,
            int samples,
            boolean again) {
        pictures++;
        // An engine may have become another one within the very call that drew.
        long original = last.filter(old -> again
                        && old.engine().equals(engine.id())
                        && old.device().equals(engine.device()))
                .map(DrawnPicture::original)
                .orElse(pictures);
        DrawnPicture picture = new DrawnPicture(
                frame,
                wanted,
                seen,
                engine.id(),
                engine.device(),
                times,
                samples,
                pictures,
                original,
                clock.getAsLong());
        last = Optional.of(picture);
        exchange.finished(picture);
        if (picture.isWhole()) {
            // Shown or not, its pixels stay: no one but this thread draws over them.
            watcher.ifPresent(eye -> eye.accept(picture));
        }
    }
}
