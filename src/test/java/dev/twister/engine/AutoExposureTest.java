package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.kernel.Tone;
import java.util.Arrays;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AutoExposureTest {
    private static final int PIXELS = 1000;

    @ParameterizedTest
    @CsvSource({"0.18, 0", "0.36, -1", "0.045, 2", "1, -2.47", "1e-30, 20", "1e30, -20", "1e-45, 20"})
    void aGrayPictureBecomesMiddleGray(float gray, double stops) {
        assertThat(AutoExposure.stops(gray(gray), true)).hasValue(stops);
    }

    @Test
    void withoutTheCurveTheScreenShowsTheSameGray() {
        double stops = AutoExposure.stops(gray(0.18f), false).orElseThrow();
        float exposed = (float) (0.18 * Math.pow(2, stops));

        assertThat(Tone.quantized(exposed, 1, Tone.CLAMP, 0)).isEqualTo(Tone.quantized(0.18f, 1, Tone.CLAMP, 1));
    }

    @Test
    void theMeanIsOfStops() {
        float[] halves = gray(0.09f);
        Arrays.fill(halves, 0, halves.length / 2, 0.36f);

        assertThat(AutoExposure.stops(halves, true)).hasValue(0);
    }

    @Test
    void whatHasNoLightDoesNotCount() {
        float[] half = gray(1);
        Arrays.fill(half, 0, half.length / 2, 0);

        assertThat(AutoExposure.stops(half, true)).hasValue(-2.47);
    }

    @ParameterizedTest
    @ValueSource(floats = {1e6f, 3e38f, 1e-40f, Float.NaN, Float.POSITIVE_INFINITY, -1})
    void fewPixelsDoNotRule(float other) {
        float[] radiance = gray(0.18f);
        Arrays.fill(radiance, 0, 3 * PIXELS / 20, other);

        assertThat(AutoExposure.stops(radiance, true)).hasValue(0);
    }

    @ParameterizedTest
    @ValueSource(floats = {0, -0f, -1, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
    void withoutLightThereIsNone(float nothing) {
        assertThat(AutoExposure.stops(gray(nothing), true)).isEqualTo(OptionalDouble.empty());
    }

    private static float[] gray(float level) {
        float[] radiance = new float[3 * PIXELS];
        Arrays.fill(radiance, level);
        return radiance;
    }
}
