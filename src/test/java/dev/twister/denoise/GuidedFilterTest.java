package dev.twister.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.denoise.NoisyPicture.Guides;
import dev.twister.denoise.NoisyPicture.Noise;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

class GuidedFilterTest {
    private static final int SIDE = 48;
    private static final int VALUES = 3 * SIDE * SIDE;

    @Test
    void removesNoiseAndKeepsEdgesOfSurfaces() {
        float[] albedo = halves(0.2f, 0.8f);
        float[] noisy = noisy(albedo, 1);
        float[] clean = new GuidedFilter().denoise(picture(noisy, albedo, Optional.empty()));

        assertThat(error(clean, albedo)).isLessThan(error(noisy, albedo) / 20);
        for (int y = 0; y < SIDE; y++) {
            assertThat(clean[3 * (y * SIDE + SIDE / 2 - 1)]).isBetween(0.1f, 0.3f);
            assertThat(clean[3 * (y * SIDE + SIDE / 2)]).isBetween(0.6f, 1f);
        }
    }

    @Test
    void pixelsOfGlassThatMirrorAreFilledWhileSamplesAreFew() {
        float[] albedo = halves(0.5f, 0.8f);
        int stray = 3 * (10 * SIDE + 10);
        for (int i = stray; i < stray + 6; i++) {
            albedo[i] = 0;
        }
        float[] one = new GuidedFilter().denoise(picture(albedo, albedo, Optional.empty()));
        Noise none = new Noise(new Plane(new float[VALUES], 0), 64);
        float[] many = new GuidedFilter().denoise(picture(albedo, albedo, Optional.of(none)));

        assertThat(one[stray]).isCloseTo(0.5f, within(1e-3f));
        assertThat(many[stray]).isZero();
    }

    /** A shadow is in no guide. */
    @Test
    void edgesOfLightComeBackWhileSamplesGather() {
        float[] light = halves(0.2f, 0.8f);
        float[] noisy = noisy(light, 0.1f);
        float[] difference = noisy(light, 0.1f);
        for (int i = 0; i < VALUES; i++) {
            difference[i] -= light[i];
        }
        float[] ones = halves(1, 1);
        Noise few = new Noise(new Plane(difference, 0), 4);
        Noise many = new Noise(new Plane(difference, 0), 4096);

        assertThat(error(new GuidedFilter().denoise(picture(noisy, ones, Optional.of(few))), light))
                .isLessThan(error(noisy, light) / 4);
        assertThat(error(new GuidedFilter().denoise(picture(noisy, ones, Optional.of(many))), noisy))
                .isLessThan(error(noisy, light) / 1000);
    }

    @Test
    void valuesThatAreNotFiniteCountAsZero() {
        float[] radiance = halves(1, 1);
        radiance[100] = Float.NaN;
        radiance[101] = Float.POSITIVE_INFINITY;
        float[] albedo = halves(0.5f, 0.5f);
        albedo[7] = Float.NaN;

        for (float value : new GuidedFilter().denoise(picture(radiance, albedo, Optional.empty()))) {
            assertThat(value).isBetween(0f, 3f);
        }
    }

    @Test
    void worksWithoutGuides() {
        float[] light = halves(0.5f, 0.5f);
        float[] noisy = noisy(light, 1);
        float[] clean = new GuidedFilter().denoise(new NoisyPicture(SIDE, SIDE, new Plane(noisy, 0), Optional.empty()));

        assertThat(error(clean, light)).isLessThan(error(noisy, light) / 20);
    }

    private static NoisyPicture picture(float[] radiance, float[] albedo, Optional<Noise> noise) {
        Plane surfaces = new Plane(albedo, 0);
        return new NoisyPicture(SIDE, SIDE, new Plane(radiance, 0), Optional.of(new Guides(surfaces, surfaces)), noise);
    }

    private static float[] halves(float left, float right) {
        float[] values = new float[VALUES];
        for (int i = 0; i < VALUES; i++) {
            values[i] = i / 3 % SIDE < SIDE / 2 ? left : right;
        }
        return values;
    }

    private static float[] noisy(float[] light, float strength) {
        Random random = new Random(1);
        float[] noisy = light.clone();
        for (int i = 0; i < VALUES; i += 3) {
            float factor = 1 + strength * (2 * random.nextFloat() - 1);
            for (int k = i; k < i + 3; k++) {
                noisy[k] *= factor;
            }
        }
        return noisy;
    }

    private static double error(float[] values, float[] right) {
        double sum = 0;
        for (int i = 0; i < VALUES; i++) {
            sum += (values[i] - right[i]) * (values[i] - right[i]);
        }
        return sum / VALUES;
    }
}
