package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The tables that are made once on the host: the shadow's disc and the samples' places. */
class TablesTest {
    @Test
    void oneShadowSampleIsTheLightsCentre() {
        assertThat(SunflowerDisc.points(1)).containsExactly(0, 0);
    }

    @Test
    void sunflowersPointsLieAtTheirDistances() {
        float[] points = SunflowerDisc.points(50);
        for (int i = 0; i < 50; i++) {
            assertThat(Math.hypot(points[2 * i], points[2 * i + 1])).isCloseTo(Math.sqrt(i / 50.0), within(1e-6));
        }
    }

    @Test
    void sunflowerTurnsByTheGoldenAngle() {
        float[] points = SunflowerDisc.points(4);
        assertThat(Math.atan2(points[3], points[2])).isCloseTo(2.399963, within(1e-5));
    }

    @Test
    void onePixelSampleIsTheCenter() {
        assertThat(PixelOffsets.places(1)).containsExactly(0.5f, 0.5f);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 7, 16, 64, 1023, 1024})
    void meanOfThePixelSamplesIsExactlyTheCenter(int samples) {
        float[] places = PixelOffsets.places(samples);
        double x = 0;
        double y = 0;
        for (int i = 0; i < samples; i++) {
            x += places[2 * i];
            y += places[2 * i + 1];
        }
        assertThat(x).isEqualTo(samples / 2.0);
        assertThat(y).isEqualTo(samples / 2.0);
    }

    @Test
    void pixelSamplesAreAllDifferent() {
        float[] places = PixelOffsets.places(1023);
        assertThat(IntStream.range(0, 1023).mapToObj(i -> List.of(places[2 * i], places[2 * i + 1])))
                .doesNotHaveDuplicates();
    }

    @Test
    void pixelSamplesStayInTheirPixel() {
        for (float place : PixelOffsets.places(1024)) {
            assertThat(place).isGreaterThan(0f).isLessThan(1f);
        }
    }

    @Test
    void pixelSamplesAreEven() {
        int[] quarters = new int[4];
        float[] places = PixelOffsets.places(1024);
        for (int i = 0; i < 1024; i++) {
            quarters[(places[2 * i] < 0.5f ? 0 : 1) + (places[2 * i + 1] < 0.5f ? 0 : 2)]++;
        }
        for (int quarter : quarters) {
            assertThat(quarter).isCloseTo(256, within(4));
        }
    }
}
