package dev.twister.render;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.EngineOffer;
import dev.twister.kernel.Layout;
import dev.twister.render.RenderOrder.BodyMotion;
import dev.twister.render.RenderOrder.Movement;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.light.Lights;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;

/** A camera that flies away from the scene's origin, 100 m per frame. */
class FilmFramesTest {
    private static final EngineOffer NO_ENGINE = EngineOffer.impossible("none", "", "", "not needed");

    private final Scene scene = SceneReader.read(Path.of("scenes", "teaching.json"));

    @Test
    void framesFarFromTheOriginShareAWorld() throws IOException {
        FilmFrames film = film();

        FrameInput one = film.frame(62);
        FrameInput next = film.frame(80);

        assertThat(one.bodies().origin()).isNotEqualTo(film.world().origin());
        assertThat(next.bodies().looks()).isSameAs(one.bodies().looks());
    }

    @Test
    void aFrameIsTheSameWhateverFramesWereBeforeIt() throws IOException {
        FilmFrames film = film();
        for (int frame = 0; frame < 100; frame++) {
            FrameInput after = film.frame(frame);
            FrameInput alone = film().frame(frame);

            assertThat(after.bodies().origin())
                    .as("frame %d", frame)
                    .isEqualTo(alone.bodies().origin());
            assertThat(after.bodies().floats()).isEqualTo(alone.bodies().floats());
        }
    }

    @Test
    void theOriginIsNearTheCamera() throws IOException {
        FilmFrames film = film();
        for (int frame = 0; frame < 1000; frame += 7) {
            Vector3 origin = film.frame(frame).bodies().origin();

            assertThat(100.0 * frame - origin.x()).as("frame %d", frame).isBetween(-4096.0, 4096.0);
        }
    }

    @Test
    void tracksMoveBodiesAndLights() throws IOException {
        FilmFrames film = film(
                seconds -> scene.withLights(Lights.of(scene.lights().first().withRadius(1 + seconds)))
                        .withSpheres(List.of(scene.spheres().getFirst().withRadius(2 + seconds))));

        FrameInput input = film.frame(3);

        assertThat(input.bodies().size(Layout.LIGHT)).isEqualTo(4);
        assertThat(input.bodies().size(Layout.FIRST_SPHERE)).isEqualTo(5);
    }

    @Test
    void aMeasuredExposureReplacesTheScenes() throws IOException {
        FilmFrames film = film(seconds -> scene.withRendering(scene.rendering().withExposure(seconds)));
        film.setExposure(1);

        assertThat(film.frame(3).view().frame()[Layout.EXPOSURE_SCALE]).isEqualTo(2);
    }

    private FilmFrames film() {
        Camera camera = scene.camera();
        return film(seconds -> scene.withCamera(camera.withPosition(new Vector3(100 * seconds, 1, 0))));
    }

    private FilmFrames film(DoubleFunction<Scene> at) {
        Movement movement = new Movement(new BodyMotion.Still(), at, 1, 0);
        RenderOrder order = new RenderOrder(
                scene,
                NO_ENGINE,
                List.of(StageOrView.BEAUTY),
                new Sampling(1, Optional.empty()),
                PicturePart.WHOLE,
                movement,
                Finishing.NONE,
                new RenderOutput(
                        Path.of("f.png"),
                        Optional.of(FrameRange.ofCount(1000)),
                        ExistingFrames.REPLACED,
                        Background.SKY));
        return new FilmFrames(order, World.of(scene, SceneImages.read(scene, _ -> {})), (_, _) -> {});
    }
}
