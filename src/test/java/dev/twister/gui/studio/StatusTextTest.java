package dev.twister.gui.studio;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.gui.WindowScenes;
import dev.twister.gui.drawing.DrawingRequest;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.DrawnPicture.Gathered;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.scene.Camera;
import dev.twister.world.FrameInput;
import dev.twister.world.Positions;
import dev.twister.world.SampleWorld;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class StatusTextTest {
    private final DrawnPicture picture = picture(1, "test", 1, 2);

    @Test
    void theNextPictureOfARequestHasTheSameFacts() {
        DrawnPicture next = picture(1, "test", 1, 2);

        assertThat(StatusText.isSame(picture, next)).isTrue();
        assertThat(StatusText.facts(next)).isEqualTo(StatusText.facts(picture));
    }

    @Test
    void anotherRequestEngineSizeOrNumberOfSamplesMayHaveOthers() {
        assertThat(StatusText.isSame(picture, picture(2, "test", 1, 2))).isFalse();
        assertThat(StatusText.isSame(picture, picture(1, "other", 1, 2))).isFalse();
        assertThat(StatusText.isSame(picture, picture(1, "test", 4, 2))).isFalse();
        assertThat(StatusText.isSame(picture(1, "test", 1, 1), picture)).isFalse();
    }

    @Test
    void bodiesThatArePouredAreCounted() {
        World world = SampleWorld.ofSize(2, 2);
        world.setBodyPositions(Positions.of(world.snapshot()), 3);
        DrawnPicture fewer = picture(1, "test", 1, 2, world.snapshot());

        assertThat(StatusText.facts(picture)).endsWith("7 bodies");
        assertThat(StatusText.facts(fewer)).endsWith("3 bodies");
        assertThat(StatusText.isSame(picture, fewer)).isFalse();
    }

    @Test
    void theNoiseIsToldWhereItIsEstimated() {
        FrameInput input = SampleWorld.ofSize(2, 2).snapshot();

        assertThat(StatusText.facts(picture)).doesNotContain("noise");
        assertThat(StatusText.facts(picture(1, "test", 64, 2, input, OptionalDouble.of(0.0123))))
                .contains("64 samples per pixel · noise 1.2 % · 7 bodies");
    }

    @Test
    void theFocusIsToldWhereThereIsALens() {
        Camera pinhole = WindowScenes.tiny().camera().withFocusDistance(5.1);

        assertThat(StatusText.facts(picture)).doesNotContain("focus");
        assertThat(StatusText.focused(pinhole))
                .isEqualTo("Focus distance: 5.1 m. The aperture is 0: everything is in focus");
        assertThat(StatusText.focused(pinhole.withAperture(0.1))).isEqualTo("Focus distance: 5.1 m");
    }

    private static DrawnPicture picture(long request, String engine, int samples, int side) {
        return picture(request, engine, samples, side, SampleWorld.ofSize(2, 2).snapshot());
    }

    private static DrawnPicture picture(long request, String engine, int samples, int side, FrameInput input) {
        return picture(request, engine, samples, side, input, OptionalDouble.empty());
    }

    private static DrawnPicture picture(
            long request, String engine, int samples, int side, FrameInput input, OptionalDouble noise) {
        return new DrawnPicture(
                Frame.ofPixels(side, side),
                new DrawingRequest(request, WindowScenes.tiny(), 2, 2, new EngineChoice(0, JvmEngines.parallel()), 0),
                input,
                SceneMeshes.NONE,
                engine,
                "a test",
                FrameTimes.NONE,
                new Gathered(samples, noise, false, false),
                1,
                1,
                1);
    }
}
