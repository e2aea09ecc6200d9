package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class IlluminationTest {
    @ParameterizedTest
    @CsvSource({"0.2, 0.9, 1, 0.9", "0.2, 0.9, 0.1, 0.2", "0.2, -0.5, 1, 0.2", "0, -0.5, 1, 0", "1, 0.9, 0.5, 1"})
    void litIsTheLargerOfAmbientAndDiffuse(float ambient, float normalDotLight, float visible, float lit) {
        assertThat(Illumination.lit(ambient, normalDotLight, visible)).isEqualTo(lit);
    }

    @Test
    void highlightsPeak() {
        float expected = (float) (0.5 * (8 + 64) / (8 * Math.PI) * 64 / 128);
        assertThat(Illumination.specular(64, 0.7f, 2f, 4f, 0.5f)).isCloseTo(expected, within(1e-6f));
    }

    @Test
    void noHighlightWhereTheLightIsBehind() {
        assertThat(Illumination.specular(64, 0f, 2f, 4f, 1f)).isZero();
    }

    @Test
    void noHighlightWhereLightAndViewerCancel() {
        assertThat(Illumination.specular(64, 0.5f, 0f, 0f, 1f)).isZero();
    }

    @Test
    void noHighlightOnAMatteBody() {
        assertThat(Illumination.specular(0, 0.5f, 2f, 4f, 1f)).isZero();
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 1",
        "0.5, 0.5, 1",
        "1, 0, 0",
        "-0.5, 0, 0",
        "-0.5, -0.5, 1",
        "-1, 0, 0",
        "-2, 0, 1",
        "3, -1, 1",
        "0.9995, 0, 0",
        "0.9985, 0, 1",
        "-0.0005, 0, 1",
        "0, -0.0015, 0"
    })
    void checkerIsEvenWhereTheFloorsAddUpEven(float x, float z, int even) {
        assertThat(SurfaceLook.isEvenSquare(x, z)).isEqualTo(even);
    }
}
