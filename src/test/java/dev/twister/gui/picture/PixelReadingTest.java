package dev.twister.gui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.Engine;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.Scenes;
import dev.twister.gui.picture.PixelInspector.PixelReading;
import dev.twister.image.Frame;
import dev.twister.scene.Rgb;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import org.junit.jupiter.api.Test;

class PixelReadingTest {
    private static final int X = Scenes.WIDTH / 2;
    private static final int Y = Scenes.HEIGHT / 2;
    private final FrameInput input = Scenes.input(Scenes.scene());

    @Test
    void aPixelHasTheRadianceOfThePicture() {
        Frame picture = Frame.ofRadiance(Scenes.WIDTH, Scenes.HEIGHT);
        try (Engine engine = JvmEngines.parallel().opener().get()) {
            engine.render(input.withSamples(0, 5), picture);
        }

        PixelReading pixel = PixelReading.of(input, 5, X, Y, 0xFF123456);

        int at = 3 * (Y * Scenes.WIDTH + X);
        assertThat(pixel.radiance())
                .isEqualTo(new Rgb(picture.radiance()[at], picture.radiance()[at + 1], picture.radiance()[at + 2]));
        assertThat(pixel.body()).isEqualTo(BodyNumber.ofSphere(0));
        assertThat(pixel.distance()).isCloseTo(8.5, within(0.01));
        assertThat(pixel.samples()).isEqualTo(5);
    }

    @Test
    void aViewHasItsNumberAndTheSkyNoDistance() {
        PixelReading depth = PixelReading.of(input.showing(StageOrView.DEPTH), 1, X, Y, 0);
        PixelReading sky = PixelReading.of(input, 1, Scenes.WIDTH - 1, 0, 0);

        assertThat(depth.radiance().red()).isCloseTo(8.5, within(0.01));
        assertThat(sky.body()).isEqualTo(BodyNumber.NONE);
        assertThat(sky.distance()).isZero();
    }
}
