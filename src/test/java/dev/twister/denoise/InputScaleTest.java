package dev.twister.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class InputScaleTest {
    @Test
    void bringsGrayToThePhotographersGray() {
        assertThat(InputScale.of(picture(0.5f))).isCloseTo(0.36f, within(1e-5f));
    }

    @Test
    void isOneForABlackPicture() {
        assertThat(InputScale.of(picture(0))).isEqualTo(1);
    }

    @Test
    void ignoresWhatIsNotFinite() {
        NoisyPicture picture = picture(0.5f);
        picture.radiance().values()[0] = Float.NaN;

        assertThat(InputScale.of(picture)).isCloseTo(0.36f, within(1e-3f));
    }

    private static NoisyPicture picture(float value) {
        float[] radiance = new float[3 * 40 * 20];
        Arrays.fill(radiance, value);
        return new NoisyPicture(40, 20, new Plane(radiance, 0), Optional.empty());
    }
}
