package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.gui.WindowScenes;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.oracle.Crowds;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class BandRendererTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 320;

    private final Paced engine = new Paced();
    private final BandRenderer pictures = new BandRenderer(() -> engine.nanos);

    /** Writes each row's number into it, and takes its time by a clock of its own. */
    private static final class Paced implements Engine {
        private long nanos;
        private long nanosARow = TimeUnit.MILLISECONDS.toNanos(1);
        private boolean bands = true;
        private final List<Integer> rows = new ArrayList<>();

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
            for (int row = 0; row < frame.height(); row++) {
                for (int column = 0; column < frame.width(); column++) {
                    int pixel = row * frame.width() + column;
                    if (frame.isLinear()) {
                        frame.radiance()[3 * pixel + 2] = input.firstRow() + row;
                    } else {
                        frame.argb()[pixel] = input.firstRow() + row;
                    }
                }
            }
            rows.add(frame.height());
            nanos += nanosARow * frame.height();
            frame.setTimes(FrameTimes.onJvm(nanosARow * frame.height()));
        }

        @Override
        public boolean drawsBandsInProportion() {
            return bands;
        }

        @Override
        public void close() {
            // It holds nothing.
        }
    }

    private static FrameInput input(int width, int height, int shadowSamples) {
        World world = World.of(WindowScenes.tiny(), new Skybox(1, 1, new float[3]));
        world.setSettings(world.settings().withSize(width, height).withShadowSamples(shadowSamples));
        return world.snapshot();
    }

    private static FrameInput withSamplesPerPixel(int samples) {
        World world = World.of(WindowScenes.tiny(), new Skybox(1, 1, new float[3]));
        world.setSettings(
                world.settings().withSize(WIDTH, HEIGHT).withShadowSamples(1).withSamplesPerPixel(samples));
        return world.snapshot();
    }

    private Frame draw(FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        assertThat(pictures.draw(engine, input, frame, _ -> false)).isTrue();
        for (int pixel = 0; pixel < frame.argb().length; pixel++) {
            assertThat(frame.argb()[pixel]).isEqualTo(pixel / input.width());
        }
        return frame;
    }

    @Test
    void aSlowPictureIsDrawnInBandsOfATenthOfASecond() {
        Frame frame = draw(input(WIDTH, HEIGHT, 1));

        assertThat(engine.rows).containsExactly(25, 100, 195);
        assertThat(frame.times().totalNanos()).isEqualTo(HEIGHT * engine.nanosARow);
        engine.rows.clear();
        draw(input(WIDTH, HEIGHT, 1));
        assertThat(engine.rows).containsExactly(100, 100, 120);
    }

    @Test
    void aFastPictureIsDrawnInOneGoOnceItIsKnown() {
        engine.nanosARow = 1000;
        draw(input(WIDTH, HEIGHT, 1));
        assertThat(engine.rows).containsExactly(25, 100, 195);
        engine.rows.clear();

        draw(input(WIDTH, HEIGHT, 1));
        assertThat(engine.rows).containsExactly(HEIGHT);
        engine.rows.clear();

        draw(input(WIDTH, HEIGHT, 200));
        assertThat(engine.rows).as("other work").containsExactly(25, 100, 195);
    }

    /** A picture of five spheres tells nothing of one of thousands, which may take the slowest engine hours. */
    @Test
    void aSceneOfMoreBodiesIsOtherWorkWhoseFirstBandIsSmaller() {
        engine.nanosARow = 1000;
        draw(input(WIDTH, HEIGHT, 1));
        engine.rows.clear();

        draw(Crowds.world(126, WIDTH, HEIGHT).snapshot());
        assertThat(engine.rows).containsExactly(6, 24, 96, 194);
        engine.rows.clear();

        draw(Crowds.world(10_000, WIDTH, HEIGHT).snapshot());
        assertThat(engine.rows).containsExactly(1, 4, 16, 64, 235);
        engine.rows.clear();

        draw(Crowds.world(10_000, WIDTH, HEIGHT).snapshot());
        assertThat(engine.rows).containsExactly(HEIGHT);
    }

    @Test
    void whatAPictureOfMeshesTakesIsGuessedOnce() {
        Scene scene = WindowScenes.tiny().withMeshes(List.of(Mesh.of(Path.of("cube.obj"))));
        World world = World.of(
                scene,
                SceneImages.of(new Skybox(1, 1, new float[3])),
                SceneMeshes.of(scene, _ -> MeshShapes.file(MeshShapes.cube())));
        world.setSettings(world.settings().withSize(WIDTH, HEIGHT));
        FrameInput meshes = world.snapshot();

        assertThat(pictures.mayTakeLong(engine, input(WIDTH, HEIGHT, 1))).isFalse();
        assertThat(pictures.mayTakeLong(engine, meshes)).isTrue();
        pictures.guess(engine, meshes, TimeUnit.SECONDS.toNanos(HEIGHT));
        assertThat(pictures.mayTakeLong(engine, meshes)).isFalse();
        assertThat(pictures.knownNanos(engine, meshes)).isEqualTo(TimeUnit.SECONDS.toNanos(HEIGHT));
    }

    /** Paths that meet the sky at once say nothing of those on the ground. */
    @Test
    void rowsOfTheSkyAreNoMeasureForTheWholePicture() {
        draw(input(WIDTH, HEIGHT, 1));
        engine.rows.clear();
        engine.nanosARow = 1000;

        draw(input(WIDTH, HEIGHT, 1));
        assertThat(engine.rows).containsExactly(100, 100, 120);
    }

    @Test
    void aRowOfSecondsIsABand() {
        engine.nanosARow = TimeUnit.SECONDS.toNanos(3);
        draw(input(Rendering.MAX_SIDE, 5, 1));
        assertThat(engine.rows).containsExactly(1, 1, 1, 1, 1);
    }

    @Test
    void smallPicturesAndThoseOfOtherEnginesAreDrawnInOneGo() {
        engine.nanosARow = TimeUnit.SECONDS.toNanos(1);
        draw(input(100, 100, 1));
        engine.bands = false;
        draw(input(WIDTH, HEIGHT, 1));
        assertThat(engine.rows).containsExactly(100, HEIGHT);
    }

    @Test
    void linearPicturesAreDrawnWhole() {
        Frame frame = Frame.ofRadiance(WIDTH, HEIGHT);
        assertThat(pictures.draw(engine, input(WIDTH, HEIGHT, 1), frame, _ -> false))
                .isTrue();
        assertThat(engine.rows).hasSizeGreaterThan(2);
        for (int i = 0; i < frame.radiance().length; i++) {
            assertThat(frame.radiance()[i]).isEqualTo(i % 3 == 2 ? i / (3 * WIDTH) : 0);
        }
    }

    @Test
    void aPictureIsLeftBetweenBandsAndTheTimeLeftIsTold() {
        List<Long> left = new ArrayList<>();
        boolean whole = pictures.draw(engine, input(WIDTH, HEIGHT, 1), Frame.ofPixels(WIDTH, HEIGHT), nanosLeft -> {
            left.add(TimeUnit.NANOSECONDS.toMillis(nanosLeft));
            return left.size() == 2;
        });

        assertThat(whole).isFalse();
        assertThat(left).containsExactly(295L, 195L);
        assertThat(engine.rows).containsExactly(25, 100);
        assertThat(pictures.knownNanos(engine, input(WIDTH, HEIGHT, 1))).isZero();
    }

    @Test
    void theTimeOfTheLastPictureIsKnown() {
        draw(input(WIDTH, HEIGHT, 1));
        assertThat(pictures.knownNanos(engine, input(WIDTH, HEIGHT, 1))).isEqualTo(HEIGHT * engine.nanosARow);
        assertThat(pictures.knownNanos(engine, input(WIDTH, HEIGHT, 2))).isZero();
        assertThat(pictures.knownNanos(engine, withSamplesPerPixel(4))).isEqualTo(4 * HEIGHT * engine.nanosARow);
        assertThat(pictures.knownNanos(new Paced(), input(WIDTH, HEIGHT, 1))).isZero();
    }
}
