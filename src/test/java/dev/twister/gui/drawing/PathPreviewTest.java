package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.gui.WindowScenes;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.gui.drawing.DrawingRequest.Refinement;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.scene.Integrator;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;
import dev.twister.world.StageOrView;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Path tracing in the window, with an engine that takes a microsecond per sample by a clock of its own. The engine
 * waits for the test before each picture, so no picture is missed.
 */
class PathPreviewTest {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final Duration LIMIT = Duration.ofMinutes(5);

    private final AtomicLong nanos = new AtomicLong();
    private final Turns turns = new Turns();
    private final EngineOffer paced = EngineOffer.working("paced", "a test", "gray", Paced::new);
    private final ImageCache skies = new ImageCache();
    private final DrawingLoop loop =
            new DrawingLoop(skies, new MeshCache(SceneMeshes.reader(skies::warn)), paced, nanos::get);
    private final Scene scene = traced(WindowScenes.tiny());
    private long requests;

    /** Lets a renderer go on when the test has seen its last picture. */
    private static final class Turns {
        private final Semaphore waiting = new Semaphore(0);
        private final Semaphore given = new Semaphore(0);

        /** On the renderer's thread: waits for a turn. */
        void await() {
            waiting.release();
            given.acquireUninterruptibly();
        }

        /** Whether a renderer waits, or comes to wait within a millisecond. */
        boolean areAwaited() {
            try {
                boolean waits = waiting.tryAcquire(1, TimeUnit.MILLISECONDS);
                if (waits) {
                    waiting.release();
                }
                return waits;
            } catch (InterruptedException problem) {
                throw new IllegalStateException(problem);
            }
        }

        void give() {
            waiting.acquireUninterruptibly();
            given.release();
        }

        /** From now on nobody waits. */
        void end() {
            given.release(Integer.MAX_VALUE / 2);
        }
    }

    private final class Paced implements Engine {
        private int frames;

        @Override
        public String id() {
            return "paced";
        }

        @Override
        public String device() {
            return "a test";
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            if (!Thread.currentThread().getName().equals("drawing")) {
                // Frames that warm up the next engine beside the pictures must not move the clock between two of them.
                frame.setTimes(FrameTimes.onJvm(0));
                return;
            }
            turns.await();
            long samples = (long) frame.width() * frame.height() * input.samplesPerPixel();
            nanos.addAndGet(TimeUnit.MICROSECONDS.toNanos(samples));
            frames++;
            Arrays.fill(frame.radiance(), frames % 2);
            frame.setTimes(FrameTimes.onJvm(TimeUnit.MICROSECONDS.toNanos(samples)));
        }

        @Override
        public boolean drawsBandsInProportion() {
            return true;
        }

        @Override
        public void close() {
            // It holds nothing.
        }
    }

    private static Scene traced(Scene plain) {
        return plain.withRendering(
                plain.rendering().withIntegrator(Integrator.PATH).withSamplesPerPixel(64));
    }

    @BeforeEach
    void start() {
        loop.start();
    }

    @AfterEach
    void end() throws InterruptedException {
        loop.close();
        turns.end();
        assertThat(loop.awaitEnd(LIMIT)).isTrue();
    }

    @Test
    void somethingIsSeenWithinHalfASecondAfterPathTracingIsChosen() {
        Scene plain = WindowScenes.tiny();
        request(plain, 1, Motion.NONE);
        await(DrawnPicture::isWhole);
        long asked = nanos.get();
        request(traced(plain), 1, Motion.NONE);
        DrawnPicture first = await(this::answers);

        assertThat(first.finishedNanos() - asked).isLessThan(TimeUnit.MILLISECONDS.toNanos(500));
        assertThat(first.frame().width()).isGreaterThanOrEqualTo(WIDTH / 8);
    }

    @Test
    void theSmallPictureGathersSamplesBeforeTheFullOneIsBegun() {
        Scene plain = WindowScenes.tiny();
        request(plain, 1, Motion.NONE);
        await(DrawnPicture::isWhole);
        long asked = nanos.get();
        request(traced(plain), 1, Motion.NONE);
        DrawnPicture small = await(picture -> answers(picture) && picture.samples() > 3);

        assertThat(small.finishedNanos() - asked).isLessThan(TimeUnit.MILLISECONDS.toNanos(500));
        assertThat(small.isWhole()).isFalse();
    }

    @Test
    void movingBodiesAreShownFiveTimesASecond() {
        request(scene, 1024, new Motion(1, true, 0));
        await(this::answers);
        List<DrawnPicture> pictures = new ArrayList<>();
        while (pictures.size() < 8) {
            long last = pictures.isEmpty() ? 0 : pictures.getLast().number();
            pictures.add(await(picture -> answers(picture) && picture.number() > last));
        }

        for (int i = 1; i < pictures.size(); i++) {
            DrawnPicture before = pictures.get(i - 1);
            DrawnPicture picture = pictures.get(i);
            long time = picture.finishedNanos() - before.finishedNanos();
            assertThat(time / (picture.number() - before.number())).isLessThan(TimeUnit.MILLISECONDS.toNanos(200));
            assertThat(picture.frame().width()).isBetween(WIDTH / 8, WIDTH / 2);
        }
    }

    @Test
    void aPictureAtRestGathersSamplesAndTellsItsNoise() {
        request(scene, 6, Motion.NONE);
        DrawnPicture picture = await(done -> done.isWhole() && done.samples() == 6);

        assertThat(picture.isWhole()).isTrue();
        assertThat(picture.noise().getAsDouble()).isPositive();
    }

    @Test
    void aRecordingHasWholePicturesOfAllSamples() {
        List<Integer> samples = new ArrayList<>();
        loop.watch(picture -> samples.add(picture.samples()));
        request(scene, 1024, new Motion(1, true, 0));
        await(picture -> picture.isWhole() && answers(picture));
        loop.unwatch();

        assertThat(samples).contains(64);
    }

    private boolean answers(DrawnPicture picture) {
        return picture.request().number() == requests;
    }

    private void request(Scene wanted, int refineTo, Motion motion) {
        requests++;
        loop.request(new DrawingRequest(
                requests,
                0,
                wanted,
                WIDTH,
                HEIGHT,
                new EngineChoice(0, paced),
                Refinement.to(refineTo),
                motion,
                StageOrView.BEAUTY));
    }

    private DrawnPicture await(Predicate<DrawnPicture> wanted) {
        long end = System.nanoTime() + LIMIT.toNanos();
        Optional<DrawnPicture> shown = Optional.empty();
        while (shown.filter(wanted).isEmpty()) {
            assertThat(System.nanoTime()).as("the time is over").isLessThan(end);
            boolean waiting = turns.areAwaited();
            shown = loop.takeNewest();
            if (waiting && shown.filter(wanted).isEmpty()) {
                turns.give();
            }
        }
        return shown.orElseThrow();
    }
}
