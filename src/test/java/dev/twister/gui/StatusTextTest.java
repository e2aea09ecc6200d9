package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.gui.drawing.DrawingRequest;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.EngineChoice;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.SampleWorld;
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

    private static DrawnPicture picture(long request, String engine, int samples, int side) {
        return new DrawnPicture(
                Frame.ofPixels(side, side),
                new DrawingRequest(request, WindowScenes.tiny(), 2, 2, new EngineChoice(0, JvmEngines.parallel()), 0),
                SampleWorld.ofSize(2, 2).snapshot(),
                engine,
                "a test",
                FrameTimes.NONE,
                samples,
                1,
                1,
                1);
    }
}
