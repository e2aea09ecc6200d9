package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.RenderStoppedException;
import dev.twister.image.Frame;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ListenedRenderingTest {
    private static final Rendering SMALL = Rendering.DEFAULT.withSize(48, 36).withShadowSamples(4);

    @AfterEach
    void clearInterrupt() {
        Thread.interrupted();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, 8, 16})
    void aPictureThatIsFollowedIsThePlainOne(int samples) {
        Scene scene = scene(samples);
        List<Double> parts = new ArrayList<>();

        RenderedPicture followed = Twister.render(scene, "sequential", (part, _, _) -> parts.add(part));

        assertThat(followed.part()).isOne();
        assertThat(parts).isSorted().endsWith(1.0);
        int[] plain = Twister.render(scene, "sequential").frame().argb();
        int[] argb = followed.frame().argb();
        for (int pixel = 0; pixel < plain.length; pixel++) {
            for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
                assertThat(argb[pixel] >>> shift & 0xff)
                        .isBetween((plain[pixel] >>> shift & 0xff) - 1, (plain[pixel] >>> shift & 0xff) + 1);
            }
        }
    }

    @Test
    void theNoiseFallsWithTheSamples() {
        List<Integer> counts = new ArrayList<>();
        List<Double> noises = new ArrayList<>();

        Twister.render(scene(64), "sequential", (_, samples, noise) -> {
            counts.add(samples);
            noises.add(noise);
        });

        assertThat(counts).isSorted().endsWith(64);
        assertThat(noises.getLast()).isPositive().isLessThan(noises.getFirst());
    }

    @ParameterizedTest
    @CsvSource({"sequential, 1", "sequential, 16", "parallel, 1", "parallel, 16", "vector, 16", "vector, 1"})
    void aCancelStopsWithinAPassAndKeepsWhatIsDone(String engine, int samples) {
        int tiles = 9;
        AtomicInteger asked = new AtomicInteger();
        RenderedPicture picture = Twister.render(scene(samples), engine, new RenderListener() {
            @Override
            public void progress(double part, int count, double noise) {
                assertThat(part).isLessThan(1);
            }

            @Override
            public boolean isCanceled() {
                return asked.incrementAndGet() > tiles;
            }
        });

        assertThat(picture.part()).isLessThan(1);
        assertThat(picture.toImage().getWidth()).isEqualTo(48);
        assertThat(Arrays.stream(picture.frame().argb())
                        .filter(pixel -> (pixel & 0xffffff) == 0)
                        .count())
                .isPositive()
                .isLessThanOrEqualTo(48 * 36);
    }

    @ParameterizedTest
    @ValueSource(strings = {"sequential", "parallel", "vector", "auto"})
    void aCancelBetweenPassesLeavesThePictureOfTheSamplesSoFar(String engine) {
        AtomicInteger reached = new AtomicInteger();
        RenderedPicture picture = Twister.render(scene(1024), engine, new RenderListener() {
            @Override
            public void progress(double part, int samples, double noise) {
                reached.set(samples);
            }

            @Override
            public boolean isCanceled() {
                return reached.get() >= 16;
            }
        });

        assertThat(reached).hasValueLessThan(32);
        assertThat(picture.part()).isPositive().isLessThan(0.1);
        assertThat(Arrays.stream(picture.frame().argb()).distinct().count()).isGreaterThan(100);
    }

    @ParameterizedTest
    @ValueSource(strings = {"sequential", "parallel", "vector", "auto"})
    void anInterruptStopsAndStays(String engine) {
        RenderedPicture picture = Twister.render(
                scene(1024), engine, (_, _, _) -> Thread.currentThread().interrupt());

        assertThat(picture.part()).isPositive().isLessThan(0.1);
        assertThat(Thread.currentThread().isInterrupted()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"sequential", "parallel", "vector", "auto"})
    void anInterruptedThreadRendersNothing(String engine) {
        FrameInput input = world(scene(1)).snapshot();
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        try (Engine opened = Engines.open(engine)) {
            Thread.currentThread().interrupt();
            assertThatThrownBy(() -> opened.render(input, frame)).isInstanceOf(RenderStoppedException.class);

            assertThat(Thread.interrupted()).isTrue();
            opened.render(input, frame);
        }
        assertThat(frame.argb()).isEqualTo(plain(scene(1), engine));
    }

    @Test
    void aFrameOfRadianceIsNoPicture() {
        assertThatThrownBy(() -> new RenderedPicture(Frame.ofRadiance(2, 2), true))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Frame.ofPixels")
                .hasMessageContaining("HdrWriter and ExrWriter");
    }

    private static int[] plain(Scene scene, String engine) {
        return Twister.render(scene, engine).frame().argb();
    }

    private static World world(Scene scene) {
        return World.of(scene, SceneImages.read(scene, _ -> {}));
    }

    private static Scene scene(int samples) {
        Scene scene = SceneReader.read(Path.of("scenes", "weekend.json"));
        return scene.withSpheres(scene.spheres().subList(0, 20))
                .withRendering(SMALL.withSamplesPerPixel(samples)
                        .withIntegrator(samples == 1 ? Integrator.WHITTED : Integrator.PATH));
    }
}
