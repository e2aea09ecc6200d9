package dev.twister.render;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.denoise.Denoiser;
import dev.twister.denoise.NoisyPicture;
import dev.twister.image.ExrPicture;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class DenoisedPictureTest {
    /** A library whose sums overflow. */
    private static final class Overflowing implements Denoiser {
        @Override
        public float[] denoise(NoisyPicture picture) {
            return new float[] {Float.POSITIVE_INFINITY, 1, Float.NaN};
        }

        @Override
        public void close() {}
    }

    @Test
    void whatOverflowsStaysAsItWas() {
        float[] noisy = {3e38f, 2, 3e38f};
        ExrPicture picture =
                new ExrPicture(1, 1, 0, 1, PictureLayers.channels(PictureLayers.COLORS, noisy, 0), Optional.empty());

        DenoisedPicture denoised = DenoisedPicture.of(picture, new Overflowing());

        assertThat(denoised.kept()).isEqualTo(2);
        assertThat(PictureLayers.of(denoised.picture(), PictureLayers.COLORS).orElseThrow())
                .containsExactly(3e38f, 1, 3e38f);
    }
}
