package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

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
    void onePixelSampleIsTheCorner() {
        assertThat(PixelOffsets.places(1)).containsExactly(0, 0);
    }

    @Test
    void pixelSamplesStayInTheirPixel() {
        for (float place : PixelOffsets.places(1024)) {
            assertThat(place).isGreaterThanOrEqualTo(0f).isLessThan(1f);
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
