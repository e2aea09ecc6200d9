package dev.twister.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** The library itself, where it is found. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class OpenImageDenoiseTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 384;

    private Optional<String> library = Optional.empty();

    @BeforeAll
    void find() {
        DenoiserOffer offer = OidnProvider.offer(LibraryPlaces.ofThisMachine());
        assumeTrue(offer.works(), () -> offer.obstacle().orElse(""));
        String name = offer.name();
        library = Optional.of(name.substring(name.indexOf(": ") + 2));
    }

    @AfterAll
    void forget() {
        library = Optional.empty();
    }

    @Test
    void removesNoise() {
        NoisyPicture noisy = picture();
        float[] denoised;
        try (Denoiser denoiser = new OpenImageDenoise(library.orElseThrow())) {
            denoised = denoiser.denoise(noisy);
        }

        assertThat(error(denoised)).isLessThan(error(noisy.radiance().values()) / 5);
    }

    @Test
    void noiseOfGuidesIsRemovedFirst() {
        float[] unguided;
        float[] guided;
        try (Denoiser denoiser = new OpenImageDenoise(library.orElseThrow())) {
            unguided = denoiser.denoise(picture());
            guided = denoiser.denoise(noisilyGuided());
        }

        assertThat(error(guided)).isLessThan(1.1 * error(unguided));
    }

    @Test
    void bandsHaveNoSeams() {
        NoisyPicture noisy = noisilyGuided();
        float[] whole;
        float[] banded;
        try (Denoiser denoiser = new OpenImageDenoise(library.orElseThrow())) {
            whole = denoiser.denoise(noisy);
        }
        try (Denoiser denoiser = new OpenImageDenoise(library.orElseThrow(), 120, 1)) {
            banded = denoiser.denoise(noisy);
        }

        assertThat(banded).usingComparatorWithPrecision(2e-3f).containsExactly(whole);
    }

    @Test
    void guidesThatAreNotFiniteCountAsZero() {
        NoisyPicture noisy = picture();
        float[] guide = new float[noisy.values()];
        guide[7] = Float.NaN;
        guide[8] = Float.POSITIVE_INFINITY;
        Plane plane = new Plane(guide, 0);
        NoisyPicture guided =
                new NoisyPicture(WIDTH, HEIGHT, noisy.radiance(), Optional.of(new NoisyPicture.Guides(plane, plane)));
        float[] denoised;
        try (Denoiser denoiser = new OpenImageDenoise(library.orElseThrow())) {
            denoised = denoiser.denoise(guided);
        }

        for (float value : denoised) {
            assertThat(value).isBetween(0f, 2f);
        }
    }

    /** Gray with noise: half of the values are 0, the others twice the mean. */
    private static NoisyPicture picture() {
        Random random = new Random(1);
        float[] radiance = new float[3 * WIDTH * HEIGHT];
        for (int pixel = 0; pixel < radiance.length; pixel += 3) {
            float value = random.nextBoolean() ? 1 : 0;
            radiance[pixel] = value;
            radiance[pixel + 1] = value;
            radiance[pixel + 2] = value;
        }
        return new NoisyPicture(WIDTH, HEIGHT, new Plane(radiance, 0), Optional.empty());
    }

    /** As above, with guides that are noisy too, and independent of the picture. */
    private static NoisyPicture noisilyGuided() {
        Random random = new Random(2);
        float[] guides = new float[2 * 3 * WIDTH * HEIGHT];
        for (int i = 0; i < guides.length; i++) {
            guides[i] = 0.5f + 0.15f * (float) random.nextGaussian();
        }
        NoisyPicture noisy = picture();
        return new NoisyPicture(
                WIDTH,
                HEIGHT,
                noisy.radiance(),
                Optional.of(new NoisyPicture.Guides(new Plane(guides, 0), new Plane(guides, guides.length / 2))));
    }

    private static double error(float[] values) {
        double sum = 0;
        for (float value : values) {
            sum += (value - 0.5) * (value - 0.5);
        }
        return Math.sqrt(sum / values.length);
    }
}
