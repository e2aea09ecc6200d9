package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.image.Frame;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.RandomScenes;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.Random;
import org.junit.jupiter.api.Test;

class FrameFitTest {
    private final FrameInput input = input();

    @Test
    void frameOfThePicturesSizeFits() {
        assertThatCode(() -> FrameFit.check(input, Frame.ofPixels(20, 10))).doesNotThrowAnyException();
    }

    @Test
    void frameOfTheBandsRowsFits() {
        assertThatCode(() -> FrameFit.check(input.band(4, 3), Frame.ofRadiance(20, 3)))
                .doesNotThrowAnyException();
    }

    @Test
    void frameOfAnotherWidthIsRefused() {
        assertThatThrownBy(() -> FrameFit.check(input, Frame.ofPixels(21, 10)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("a frame of 21 x 10 for 10 rows of a picture 20 wide");
    }

    @Test
    void wholeFrameForABandIsRefusedByEveryEngine() {
        try (Engine engine = Engines.open(JvmEngines.SEQUENTIAL)) {
            assertThatThrownBy(() -> engine.render(input.band(4, 3), Frame.ofPixels(20, 10)))
                    .isInstanceOf(IllegalArgumentException.class);
        }
    }

    private static FrameInput input() {
        LitScene random = RandomScenes.scene(new Random(1), 1);
        World world = World.of(random.scene(), random.sky());
        world.setSettings(world.settings().withSize(20, 10));
        return world.snapshot();
    }
}
