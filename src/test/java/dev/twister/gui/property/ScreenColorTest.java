package dev.twister.gui.property;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.kernel.Tone;
import dev.twister.scene.Rgb;
import org.junit.jupiter.api.Test;

class ScreenColorTest {
    @Test
    void aColorIsShownAsThePictureShowsIt() {
        for (int level = 0; level <= 255; level++) {
            double linear = level / 255.0;
            for (boolean srgb : new boolean[] {false, true}) {
                double shown = ScreenColor.shown(new Rgb(linear, 0, 0), srgb).red();
                assertThat(255 * shown)
                        .isCloseTo(Tone.quantized((float) linear, 1, Tone.CLAMP, srgb ? 1 : 0), within(0.51));
            }
        }
    }

    @Test
    void whatIsShownLeadsBack() {
        for (int level = 0; level <= 255; level++) {
            Rgb linear = new Rgb(level / 255.0, 0.5, 1);
            Rgb back = ScreenColor.linear(ScreenColor.shown(linear, true), true);
            assertThat(back.red()).isCloseTo(linear.red(), within(1e-6));
            assertThat(back.blue()).isEqualTo(1, within(1e-6));
        }
    }
}
