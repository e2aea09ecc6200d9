package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.denoise.DenoiseException;
import dev.twister.denoise.Denoiser;
import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.FakeDenoiser;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.WindowScenes;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.gui.drawing.DrawingRequest.Refinement;
import dev.twister.scene.Integrator;
import dev.twister.scene.Scene;
import dev.twister.scene.ToneMap;
import dev.twister.world.SceneMeshes;
import dev.twister.world.StageOrView;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Path-traced pictures at rest: without their noise, and until it is low. */
class BackgroundDenoisingTest {
    private static final int SIDE = 24;
    private static final int SAMPLES = 40;
    private static final Duration LIMIT = Duration.ofMinutes(5);
    private static final DenoiserOffer FAKE = DenoiserOffer.working("fake", FakeDenoiser::new);

    private final ImageCache skies = new ImageCache();
    private final DrawingLoop loop =
            new DrawingLoop(skies, new MeshCache(SceneMeshes.reader(skies::warn)), JvmEngines.parallel());
    private final EngineChoice engine = new EngineChoice(0, JvmEngines.parallel());
    private final Scene scene = scene(Integrator.PATH);
    private long requests;

    private static Scene scene(Integrator integrator) {
        Scene tiny = WindowScenes.tiny();
        return tiny.withRendering(tiny.rendering()
                .withIntegrator(integrator)
                .withTone(0, ToneMap.CLAMP, false)
                .withSamplesPerPixel(4));
    }

    @BeforeEach
    void start() {
        loop.start();
    }

    @AfterEach
    void end() throws InterruptedException {
        loop.close();
        assertThat(loop.awaitEnd(LIMIT)).isTrue();
    }

    @Test
    void aPictureThatRestsHasBeenDenoised() {
        request(scene, new Refinement(SAMPLES, 0, Optional.of(FAKE)));
        DrawnPicture rested = await(picture -> picture.gathered().isDone());

        assertThat(rested.gathered().denoised()).isTrue();
        assertThat(rested.samples()).isEqualTo(SAMPLES);
        // The fake adds ten times the albedo.
        assertThat(loop.radiance(rested).join().orElseThrow()[0]).isGreaterThan(1);
    }

    @Test
    void itsToneChangesAtOnce() {
        request(scene, new Refinement(SAMPLES, 0, Optional.of(FAKE)));
        await(picture -> picture.gathered().isDone());
        Scene darker = scene.withRendering(scene.rendering().withTone(-20, ToneMap.CLAMP, false));
        request(darker, new Refinement(SAMPLES, 0, Optional.of(FAKE)));
        DrawnPicture toned = await(picture -> picture.request().number() == requests);

        assertThat(toned.gathered().denoised()).isTrue();
        assertThat(toned.frame().argb()[0] & 0xFF).isZero();
    }

    @Test
    void aFailureIsSaidAndLeavesTheNoise() {
        DenoiserOffer broken = DenoiserOffer.working("broken", BackgroundDenoisingTest::fail);
        request(scene, new Refinement(SAMPLES, 0, Optional.of(broken)));
        DrawnPicture rested = await(picture -> picture.gathered().isDone());

        assertThat(rested.gathered().denoised()).isFalse();
        assertThat(rested.samples()).isEqualTo(SAMPLES);
        while (loop.status().engineFailure().isEmpty()) {
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
        }
        assertThat(loop.status().engineFailure()).contains("not denoised: it broke");
    }

    private static Denoiser fail() {
        throw new DenoiseException("it broke");
    }

    @Test
    void picturesWithoutPathTracingAreLeftAsTheyAre() {
        request(scene(Integrator.WHITTED), new Refinement(SAMPLES, 1, Optional.of(FAKE)));
        DrawnPicture rested = await(picture -> picture.gathered().isDone());

        assertThat(rested.gathered().denoised()).isFalse();
        assertThat(rested.samples()).isEqualTo(SAMPLES);
    }

    @Test
    void aPictureRestsAtItsNoise() {
        request(scene, new Refinement(4096, 0.2, Optional.empty()));
        DrawnPicture rested = await(picture -> picture.gathered().isDone());

        assertThat(rested.noise().orElseThrow()).isLessThanOrEqualTo(0.2);
        assertThat(rested.samples()).isBetween(16, 4095);
    }

    @Test
    void itsSamplesAreKeptWhenDenoisingIsSwitched() {
        request(scene, new Refinement(SAMPLES, 0, Optional.empty()));
        await(picture -> picture.gathered().isDone());
        request(scene, new Refinement(SAMPLES, 0, Optional.of(FAKE)));
        DrawnPicture clean = await(picture -> {
            assertThat(picture.samples()).isGreaterThanOrEqualTo(SAMPLES);
            return picture.gathered().denoised() && picture.gathered().isDone();
        });
        request(scene, new Refinement(SAMPLES, 0, Optional.empty()));
        DrawnPicture noisy = await(picture -> picture.request().number() == requests);

        // The guides need samples of their own.
        assertThat(clean.samples()).isBetween(SAMPLES + 1, SAMPLES + 32);
        assertThat(noisy.gathered().denoised()).isFalse();
        assertThat(noisy.samples()).isEqualTo(clean.samples());
        assertThat(loop.radiance(noisy).join().orElseThrow()[0]).isLessThan(1);
    }

    @Test
    void itsSamplesAreKeptWhenItRestsAtAnotherNoise() {
        request(scene, new Refinement(4096, 0.2, Optional.empty()));
        int samples = await(picture -> picture.gathered().isDone()).samples();
        request(scene, new Refinement(4096, 0.1, Optional.empty()));
        DrawnPicture rested = await(picture -> {
            assertThat(picture.samples()).isGreaterThanOrEqualTo(samples);
            return picture.request().number() == requests && picture.gathered().isDone();
        });

        assertThat(rested.noise().orElseThrow()).isLessThanOrEqualTo(0.1);
    }

    @Test
    void aFailureIsForgottenWithDenoising() {
        DenoiserOffer broken = DenoiserOffer.working("broken", BackgroundDenoisingTest::fail);
        request(scene, new Refinement(SAMPLES, 0, Optional.of(broken)));
        await(picture -> picture.gathered().isDone());
        request(scene, new Refinement(SAMPLES, 0, Optional.empty()));
        await(picture -> picture.request().number() == requests);

        long end = System.nanoTime() + LIMIT.toNanos();
        while (loop.status().engineFailure().isPresent()) {
            assertThat(System.nanoTime()).isLessThan(end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
        }
    }

    private void request(Scene wanted, Refinement refinement) {
        requests++;
        loop.request(new DrawingRequest(
                requests, 0, wanted, SIDE, SIDE, engine, refinement, Motion.NONE, StageOrView.BEAUTY));
    }

    private DrawnPicture await(Predicate<DrawnPicture> condition) {
        long end = System.nanoTime() + LIMIT.toNanos();
        Optional<DrawnPicture> taken = Optional.empty();
        while (taken.filter(condition).isEmpty()) {
            assertThat(System.nanoTime()).isLessThan(end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
            taken = loop.takeNewest();
        }
        return taken.orElseThrow();
    }
}
