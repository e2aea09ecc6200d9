package dev.twister.gui.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.denoise.FakeDenoiser;
import dev.twister.denoise.NoisyPicture.Guides;
import dev.twister.denoise.Plane;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(FakeDenoiser.Offered.class)
class RelitDenoisingTest {
    private static final List<Rgb> UNCHANGED = List.of(new Rgb(1, 1, 1));
    private static final List<Rgb> TWICE = List.of(new Rgb(2, 2, 2));

    @Test
    void aChangedLightIsDenoisedWithTheGuidesOfTheFile() {
        ViewedPicture.Denoising denoising = new ViewedPicture.Denoising(picture(Optional.of(guides()), true));

        assertThat(denoising.isDue(UNCHANGED)).isFalse();
        assertThat(denoising.isDue(TWICE)).isTrue();
        // The fake adds ten times the albedo and a hundred times the normal.
        assertThat(denoising.clean(TWICE)).containsExactly(16, 18, 20);
        assertThat(denoising.isDue(TWICE)).isFalse();
        assertThat(denoising.known(TWICE).orElseThrow()).containsExactly(16, 18, 20);
        assertThat(denoising.known(UNCHANGED).orElseThrow()).containsExactly(7, 8, 9);
    }

    @Test
    void aNoisyFileIsDenoisedAsItIs() {
        assertThat(new ViewedPicture.Denoising(picture(Optional.of(guides()), false)).isDue(UNCHANGED))
                .isTrue();
    }

    @Test
    void withoutGuidesNothingIsDone() {
        assertThat(new ViewedPicture.Denoising(picture(Optional.empty(), false)).isDue(TWICE))
                .isFalse();
    }

    private static Guides guides() {
        return new Guides(new Plane(new float[] {1, 1, 1}, 0), new Plane(new float[3], 0));
    }

    private static ViewedPicture picture(Optional<Guides> guides, boolean denoised) {
        ViewedPicture.Light light = new ViewedPicture.Light("lamp", new float[] {3, 4, 5});
        Optional<float[]> clean = Optional.of(new float[] {7, 8, 9}).filter(_ -> denoised);
        return new ViewedPicture(
                1, 1, new float[] {1, 2, 3}, Rendering.DEFAULT, List.of(light), guides, clean, Optional.empty());
    }
}
