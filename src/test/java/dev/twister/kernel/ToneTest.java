package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ToneTest {
    @Test
    void srgbCurveKeepsItsBound() {
        double largest = 0;
        for (int i = 0; i <= 1_000_000; i++) {
            float linear = i * 1e-6f;
            double expected = linear <= 0.0031308 ? 12.92 * linear : 1.055 * StrictMath.pow(linear, 1 / 2.4) - 0.055;
            largest = Math.max(largest, Math.abs(Tone.srgbEncoded(linear) - expected));
        }
        assertThat(largest).isLessThan(2e-6);
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 0",
        "0.4, 0, 102",
        "1, 0, 255",
        "50, 0, 255",
        "1, 1, 128",
        "3, 1, 191",
        "0.18, 2, 68",
        "1, 2, 205",
        "50, 2, 255"
    })
    void curvesAtKnownValues(float radiance, int operator, int shown) {
        assertThat(Tone.quantized(radiance, 1f, operator, 0f)).isEqualTo(shown);
    }

    @ParameterizedTest
    @ValueSource(ints = {Tone.CLAMP, Tone.REINHARD, Tone.ACES})
    void anEndlessRadianceIsWhite(int operator) {
        assertThat(Tone.quantized(Float.POSITIVE_INFINITY, 4f, operator, 1f)).isEqualTo(255);
    }

    @ParameterizedTest
    @ValueSource(ints = {Tone.CLAMP, Tone.REINHARD, Tone.ACES})
    void brighterNeverShowsDarker(int operator) {
        int last = 0;
        for (float radiance = 0f; radiance < 20f; radiance += 1e-3f) {
            int shown = Tone.quantized(radiance, 1f, operator, 1f);
            assertThat(shown).isGreaterThanOrEqualTo(last);
            last = shown;
        }
    }

    @Test
    void exposureComesBeforeTheCurve() {
        assertThat(Tone.quantized(0.25f, 4f, Tone.REINHARD, 0f)).isEqualTo(128);
    }
}
