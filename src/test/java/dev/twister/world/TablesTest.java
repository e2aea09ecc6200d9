package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.kernel.Layout;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The tables that are computed once on the host: the unit disc of shadow samples and the pixel samples. */
class TablesTest {
    @Test
    void oneShadowSampleIsTheLightsCenter() {
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
        assertThat(PixelSamples.of(1)).startsWith(0.5f, 0.5f).hasSize(Layout.SAMPLE_STRIDE);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 7, 16, 64, 1023, 1024})
    void meanOfThePixelSamplesIsExactlyTheCenter(int samples) {
        float[] places = PixelSamples.of(samples);
        double x = 0;
        double y = 0;
        for (int i = 0; i < samples; i++) {
            x += places[Layout.SAMPLE_STRIDE * i];
            y += places[Layout.SAMPLE_STRIDE * i + 1];
        }
        assertThat(x).isEqualTo(samples / 2.0);
        assertThat(y).isEqualTo(samples / 2.0);
    }

    @Test
    void pixelSamplesAreAllDifferent() {
        float[] places = PixelSamples.of(1023);
        assertThat(IntStream.range(0, 1023)
                        .mapToObj(i -> List.of(places[Layout.SAMPLE_STRIDE * i], places[Layout.SAMPLE_STRIDE * i + 1])))
                .doesNotHaveDuplicates();
    }

    @Test
    void pixelSamplesStayInTheirPixel() {
        float[] places = PixelSamples.of(1024);
        for (int i = 0; i < places.length; i++) {
            boolean isPlace = i % Layout.SAMPLE_STRIDE < Layout.SAMPLE_LENS;
            assertThat(places[i]).isBetween(isPlace ? Math.nextUp(0f) : 0f, Math.nextDown(1f));
        }
    }

    @Test
    void pixelSamplesAreEven() {
        int[] quarters = new int[4];
        float[] places = PixelSamples.of(1024);
        for (int i = 0; i < 1024; i++) {
            quarters[
                    (places[Layout.SAMPLE_STRIDE * i] < 0.5f ? 0 : 1)
                            + (places[Layout.SAMPLE_STRIDE * i + 1] < 0.5f ? 0 : 2)]++;
        }
        for (int quarter : quarters) {
            assertThat(quarter).isCloseTo(256, within(4));
        }
    }
}
